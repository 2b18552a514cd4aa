// What the library answers, shown: blocks of sentences and formulas, verdicts, numbers with their sliders.
const WORDS = { STABLE: ["✓", "Stable"], UNSTABLE: ["✗", "Unstable"], UNDECIDED: ["?", "Undecided"] };
const START = { I2: "1.2", I3: "1.6", l: "0", k3: "0.5" };

export function element(name, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...children);
  return made;
}

export function formula(latex, displayMode = false) {
  const place = element(displayMode ? "div" : "span", { className: displayMode ? "display" : "" });
  if (displayMode) place.tabIndex = 0;                  // what is wider than the page is scrolled by keys too
  katex.render(latex, place, { displayMode, throwOnError: false });
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

export function shown(place, blocks) {
  place.replaceChildren(...blocks.map(block));
}

// A list that scrolls by itself, each equilibrium in the colour of its verdict.
function every(place, reasons, all) {
  const list = element("ol", { className: "reasons", tabIndex: 0, ariaLabel: "equilibria" });
  list.append(...all.map(({ verdict: found, blocks }) => {
    const item = element("li", { className: found.toLowerCase() });
    shown(item, blocks);
    return item;
  }));
  place.className = "every";
  place.replaceChildren(
    element("p", { className: "badge" }, `${all.length} equilibri${all.length === 1 ? "um" : "a"}`));
  reasons.replaceChildren(list);
}

// The word in its place, why in another.
export function verdict(place, reasons, { verdict: found, found: all, damped, blocks }) {
  if (all) return every(place, reasons, all);
  const [sign, word] = WORDS[found];
  place.className = found.toLowerCase();
  place.replaceChildren(
    element("p", { className: "badge" }, element("span", { ariaHidden: "true" }, sign), ` ${word}`),
    element("p", { className: "damped" }, `under internal damping: ${damped.toLowerCase()}`));
  shown(reasons, blocks);
}

export function noVerdict(place, reasons) {
  place.className = "";
  place.replaceChildren(element("p", { className: "badge" }, "No verdict"));
  reasons.replaceChildren();
}

export const word = (found) => WORDS[found][1].toLowerCase();

// The double nearest to a text; of another text than 1.25 or 1/2 what the library has said. NaN of what is none.
const said = new Map();
export function number(text) {
  const [above, below = "1", more] = text.split("/");
  const value = text.trim() && !more ? Number(above) / Number(below) : NaN;
  return Number.isNaN(value) ? said.get(text) ?? value : value;
}

// What the library says of texts; whether it tells anything.
export function heard(values, doubles) {
  const told = Object.entries(doubles).filter(([name]) => Number.isNaN(number(values[name])));
  for (const [name, value] of told) said.set(values[name], value);
  return told.length > 0;
}

function ends(name, value) {
  if (/^[knr]\d?$/.test(name)) return [-1, 1];
  if (/^(I\d+|M|omega0)$/.test(name)) return [0.05, Math.max(5, 2 * value || 0)];
  const most = Math.max(5, 2 * Math.abs(value) || 0);
  return [-most, most];
}

// A row for each name: its symbol, a text that is exact, a slider. changed() after each change of values.
export function sliders(place, names, values, changed) {
  place.replaceChildren(...names.map(({ name, tex, meaning }) => {
    values[name] ??= START[name] ?? "1";
    const [min, max] = ends(name, number(values[name]));
    const text = element("input", { id: `value-${name}`, value: values[name], size: 8, maxLength: 500,
      spellcheck: false, autocomplete: "off" });
    const slider = element("input", { type: "range", min, max, step: 0.01, ariaLabel: `${name}, slider` });
    text.oninput = () => { values[name] = text.value; placed(place); changed(); };
    slider.oninput = () => { values[name] = text.value = slider.value; changed(); };
    const label = element("label", { htmlFor: text.id, title: name }, formula(tex));
    return element("div", { className: "value" }, label, text, slider, element("small", {}, meaning));
  }));
  placed(place);
}

// Sliders where their texts are.
export function placed(place) {
  for (const row of place.querySelectorAll(".value")) {
    const value = number(row.querySelector("[id]").value);
    if (Number.isFinite(value)) row.querySelector("[type=range]").value = value;
  }
}
