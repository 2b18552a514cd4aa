// What the library answers, shown: blocks of sentences and formulas, verdicts.

const WORDS = { STABLE: ["✓", "Stable"], UNSTABLE: ["✗", "Unstable"], UNDECIDED: ["?", "Undecided"] };

export function element(name, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...children);
  return made;
}

// Without KaTeX as it is written; without its style by the browser's own mathematics.
let output = "htmlAndMathml";
export function unstyled() {
  output = "mathml";
}

export function formula(latex, displayMode = false) {
  const place = element(displayMode ? "div" : "span", { className: displayMode ? "display" : "" });
  if (displayMode) place.tabIndex = 0;                  // what is wider than the page is scrolled by keys too
  if (globalThis.katex) katex.render(latex, place, { displayMode, output, throwOnError: false });
  else place.append(element("code", {}, latex));
  return place;
}

const parts = (given) => given.map(({ text, tex }) => text ?? formula(tex));

function block({ heading, level, sentence, display, title, rows }) {
  if (heading !== undefined) return element(`h${level + 2}`, {}, heading);
  if (display !== undefined) return formula(display, true);
  if (sentence !== undefined) return element("p", {}, ...parts(sentence));
  return element("table", {}, element("caption", {}, title),
    ...rows.map(([symbol, meaning]) => element("tr", {}, element("th", { scope: "row" }, ...parts(symbol)),
      element("td", {}, ...parts(meaning)))));
}

// The blocks of an answer, why there are none, or nothing.
export function shown(place, { blocks = [], error } = {}) {
  place.replaceChildren(...error ? [element("p", {}, error)] : blocks.map(block));
}

// A list that scrolls by itself, each equilibrium in the colour of its verdict.
function every(place, reasons, all) {
  const list = element("ol", { className: "reasons", tabIndex: 0, ariaLabel: "equilibria" });
  list.append(...all.map(({ verdict: found, blocks }) => {
    const item = element("li", { className: found.toLowerCase() });
    shown(item, { blocks });
    return item;
  }));
  place.className = "answer every";
  place.replaceChildren(
    element("p", { className: "badge" }, `${all.length} equilibri${all.length === 1 ? "um" : "a"}`));
  reasons.replaceChildren(list);
}

// The word in its place, why in another; none where there is none.
export function verdict(place, reasons, { verdict: found, found: all, damped, blocks } = {}) {
  if (all) return every(place, reasons, all);
  const [sign, word] = WORDS[found] ?? ["", "No verdict"];
  place.className = `answer ${found?.toLowerCase() ?? ""}`;
  place.replaceChildren(
    element("p", { className: "badge" }, element("span", { ariaHidden: "true" }, sign), ` ${word}`),
    ...damped ? [element("p", { className: "damped" }, `under internal damping: ${damped.toLowerCase()}`)] : []);
  shown(reasons, { blocks });
}

export const word = (found) => WORDS[found][1].toLowerCase();
