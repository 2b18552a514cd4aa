// What the library answers, shown: blocks of sentences and formulas, verdicts.

/**
 * A part of a sentence: text, or a formula in LaTeX.
 * @typedef {{ text?: string, tex?: string }} Part
 */
/**
 * A block: a heading, a formula of its own, a sentence, or a table with a title.
 * @typedef {{ heading?: string, level?: number, sentence?: Part[], display?: string, title?: string, rows?: Part[][][] }} Block
 */
/**
 * A verdict with its reasons; or a list of equilibria.
 * @typedef {{ verdict?: string, found?: { verdict: string, blocks: Block[] }[], damped?: string, blocks?: Block[] }} Decided
 */

/** @type {Record<string, [sign: string, word: string]>} */
const WORDS = { STABLE: ["✓", "Stable"], UNSTABLE: ["✗", "Unstable"], UNDECIDED: ["?", "Undecided"] };

/**
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, any>} attributes
 * @param {(Node | string)[]} children
 */
export function element(name, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...children);
  return made;
}

/** Another text in a place; the same costs nothing. @param {Element} place @param {string} text */
export function say(place, text) {
  if (place.textContent !== text) place.textContent = text;
}

let output = "htmlAndMathml";
/** Without the style of KaTeX formulas are set by the browser. */
export function unstyled() {
  output = "mathml";
}

/** A formula; without KaTeX as it is written. @param {string} latex */
export function formula(latex, displayMode = false) {
  const place = element(displayMode ? "div" : "span", { className: displayMode ? "display" : "" });
  if (displayMode) place.tabIndex = 0;                  // what is wider than the page is scrolled by keys too
  place.append(element("code", { className: "latex" }, latex));
  if (globalThis.katex) set(place, latex);
  return place;
}

/** @param {HTMLElement} place @param {string} latex */
const set = (place, latex) => globalThis.katex?.render(latex, place,
  { displayMode: place.className === "display", output, throwOnError: false });

/** KaTeX has come: what is there as it is written is set. */
export function typeset() {
  for (const code of document.querySelectorAll("code.latex")) {
    if (code.parentElement) set(code.parentElement, code.textContent ?? "");
  }
}

/** @param {Part[]} given */
const parts = (given) => given.map(({ text, tex = "" }) => text ?? formula(tex));

/** @param {Block} given */
function block({ heading, level = 1, sentence, display, title = "", rows = [] }) {
  if (heading !== undefined) return element(/** @type {"h3"} */ (`h${level + 2}`), {}, heading);
  if (display !== undefined) return formula(display, true);
  if (sentence !== undefined) return element("p", {}, ...parts(sentence));
  return element("table", {}, element("caption", {}, title),
    ...rows.map((cells) => element("tr", {}, ...cells.map((cell) => element("td", {}, ...parts(cell))))));
}

/**
 * The blocks of an answer, why there are none, or nothing.
 * @param {Element} place
 * @param {{ blocks?: Block[], error?: string }} [answer]
 */
export function shown(place, { blocks = [], error } = {}) {
  place.replaceChildren(...error ? [element("p", {}, error)] : blocks.map(block));
}

/**
 * A list that scrolls by itself, each equilibrium in the colour of its verdict.
 * @param {Element} place
 * @param {Element} reasons
 * @param {{ verdict: string, blocks: Block[] }[]} all
 */
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

/**
 * The word in its place, why in another; none where there is none.
 * @param {Element} place
 * @param {Element} reasons
 * @param {Decided} [answer]
 */
export function verdict(place, reasons, { verdict: found, found: all, damped, blocks } = {}) {
  if (all) return every(place, reasons, all);
  const [sign, word] = found ? WORDS[found] : ["", "No verdict"];
  place.className = `answer ${found?.toLowerCase() ?? ""}`;
  place.replaceChildren(
    element("p", { className: "badge" }, element("span", { ariaHidden: "true" }, sign), ` ${word}`),
    ...damped ? [element("p", { className: "damped" }, `under internal damping: ${damped.toLowerCase()}`)] : []);
  shown(reasons, { blocks });
}

/** @param {keyof typeof WORDS} found */
export const word = (found) => WORDS[found][1].toLowerCase();
