// What the library answers, shown: blocks of sentences and formulas, verdicts, numbers with their sliders.
import { number, positive } from "../app/numbers.js";

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
const START = new Map([["I2", "1.2"], ["I3", "1.6"], ["l", "0"], ["k3", "0.5"]]);

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

let output = "htmlAndMathml";
/** Without the style of KaTeX formulas are set by the browser. */
export function unstyled() {
  output = "mathml";
}

/** A formula; without KaTeX as it is written. @param {string} latex */
export function formula(latex, displayMode = false) {
  const place = element(displayMode ? "div" : "span", { className: displayMode ? "display" : "" });
  if (displayMode) place.tabIndex = 0;                  // what is wider than the page is scrolled by keys too
  if (globalThis.katex) globalThis.katex.render(latex, place, { displayMode, output, throwOnError: false });
  else place.append(element("code", {}, latex));
  return place;
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

export const word = (found) => WORDS[found][1].toLowerCase();

function ends(name, value) {
  if (positive.has(name) || name === "M") return [0.05, Math.max(5, 2 * value || 0)];
  if (/^[knr]\d?$/.test(name)) return [-1, 1];
  const most = Math.max(5, 2 * Math.abs(value) || 0);
  return [-most, most];
}

/**
 * Gives a number, and the ends of its slider, to each name that has none.
 * @param {import("../app/scene.js").Asked} asked
 * @param {{ name: string, positive: boolean }[]} names
 */
export function fitted({ values, ends: shown }, names) {
  for (const { name, positive: above } of names) {
    if (above) positive.add(name);
    values[name] ??= START.get(name) ?? "1";
    shown[name] ??= ends(name, number(name, values[name])).map(String);
  }
}

/**
 * A row for each name: its symbol, a text that is exact, a slider. changed() after each change of values.
 * @param {Element} place
 * @param {any[]} names
 * @param {import("../app/scene.js").Asked} asked
 * @param {() => void} changed
 */
export function sliders(place, names, { values, ends: shown }, changed) {
  place.replaceChildren(...names.map(({ name, tex, meaning }) => {
    const [min, max] = shown[name];
    const text = element("input", { id: `value-${name}`, value: values[name], size: 8, maxLength: 500,
      spellcheck: false, autocomplete: "off", autocapitalize: "none" });
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
    const text = row.querySelector("[id]");
    const value = number(text.id.slice(6), text.value);
    if (Number.isFinite(value)) row.querySelector("[type=range]").value = value;
  }
}
