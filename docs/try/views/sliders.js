// Numbers: each a text that is exact, and a slider, on the scale that the chart has too.
import { number, positive, possible } from "../app/numbers.js";
import { element, formula } from "./blocks.js";
import { fitted as scaled, numberAt, stepOf, steps, widened, written } from "./scales.js";

/** @typedef {import("../app/scene.js").Asked} Asked */
/** @typedef {import("./scales.js").Name & {tex: string, meaning: string}} Name */

const START = new Map([["I2", "1.2"], ["I3", "1.6"], ["l", "0"], ["k3", "0.5"]]);

/**
 * Gives a number to each name that has none, and a scale to each that has none or whose number has left it.
 * @param {Asked} asked
 * @param {Name[]} names
 */
export function fitted(asked, names) {
  for (const { name, positive: above } of names) {
    if (above) positive.add(name);
    asked.values[name] ??= START.get(name) ?? "1";
  }
  asked.scales = scaled(asked.scales, names, (name) => possible(name, asked.values[name]), asked.ends);
}

/**
 * A row for each name: its symbol, a text that is exact, a slider.
 * @param {Element} place
 * @param {Name[]} names
 * @param {Asked} asked
 * @param {() => void} changed called after each change of a number
 */
export function sliders(place, names, asked, changed) {
  place.replaceChildren(...names.map((name) => row(name, asked, changed)));
  placed(place, asked);
}

/** @param {Name} of @param {Asked} asked @param {() => void} changed */
function row({ name, tex, meaning }, asked, changed) {
  const text = element("input", { id: `value-${name}`, value: asked.values[name], size: 8, maxLength: 500,
    spellcheck: false, autocomplete: "off", autocapitalize: "none" });
  const slider = element("input", { type: "range", min: 0, step: 1, ariaLabel: `${name}, slider` });
  const scale = () => /** @type {import("./scales.js").Scale} */ (asked.scales.get(name));
  text.oninput = () => {
    asked.values[name] = text.value;
    asked.scales.set(name, { ...scale(), open: true });
    changed();
  };
  slider.oninput = () => {
    asked.values[name] = text.value = written(numberAt(scale().ends, Number(slider.value)));
    changed();
  };
  slider.onchange = () => {                             // it is let go at an end
    if (slider.value !== slider.max && slider.value !== slider.min) return;
    asked.scales.set(name, widened(scale(), numberAt(scale().ends, Number(slider.value))));
    changed();
  };
  const label = element("label", { htmlFor: text.id, title: name }, formula(tex));
  return element("div", { className: "value" }, label, text, slider, element("small", {}, meaning));
}

/** Texts as they are asked, the spin's other number too, and sliders there. @param {Element} place @param {Asked} asked */
export function placed(place, { scales, values }) {
  for (const row of /** @type {Iterable<HTMLElement>} */ (place.children)) {
    const [, text, slider] = /** @type {Iterable<any>} */ (row.children), name = text.id.slice(6);
    const { ends } = /** @type {import("./scales.js").Scale} */ (scales.get(name));
    if (text.value !== values[name]) text.value = values[name];
    const value = number(name, text.value);
    [row.dataset.low, row.dataset.high] = ends.map(String);
    slider.max = String(steps(ends));
    if (!Number.isFinite(value)) continue;
    const step = String(stepOf(ends, value));
    if (slider.value !== step) slider.value = step;
    slider.ariaValueText = written(Number(value.toPrecision(4)));
  }
}
