// The axes of a chart: which two names they are, where their ticks are, and what stands beside them.
import { nice } from "./scales.js";

/** @typedef {import("./scales.js").Ends} Ends */
/** @typedef {{value: number, text: string}} Tick */
/** @typedef {{ticks: Tick[], step: number, power: number}} Ticks  a tick reads text times 10 to the power */

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/**
 * The names across and upwards: those that are wanted, if they are free and differ, and in the place of the others the
 * last ones; "" where there is none.
 * @param {string[]} free those that an axis may have
 * @param {string[]} wanted two, "" where any will do
 */
export function paired(free, wanted) {
  const kept = wanted.map((name, n) => free.includes(name) && wanted.indexOf(name) === n ? name : "");
  const others = free.filter((name) => !kept.includes(name)).slice(-kept.filter((name) => !name).length);
  return kept.map((name) => name || (others.shift() ?? ""));
}

/**
 * Ticks 1, 2 or 5 times a power of ten apart: at most most + 1 of them, at least two if most is 5 or more.
 * What would be written with many zeros has a power of ten that all ticks of the axis share.
 * @param {Ends} ends
 * @param {number} most
 * @returns {Ticks}
 */
export function ticked([low, high], most) {
  const step = nice((high - low) / most);
  const far = Math.floor(Math.log10(Math.max(Math.abs(low), Math.abs(high))));
  const power = far < -2 || far > 3 ? far : 0;
  const decimals = Math.max(0, power - Math.floor(Math.log10(step) + 1e-9));
  const ticks = [];
  for (let n = Math.ceil(low / step - 1e-9); n <= Math.floor(high / step + 1e-9); n++) {
    const text = (n * (step / 10 ** power)).toFixed(decimals).replace("-", "−");
    ticks.push({ value: Math.min(Math.max(n * step, low), high), text: n === 0 ? "0" : text });
  }
  return { ticks, step, power };
}

/**
 * The most ticks of which none overlaps the next: each has a number of pixels for every character, and a gap.
 * @param {Ends} ends
 * @param {number} length in pixels
 * @param {(text: string) => number} room pixels that a text takes
 * @returns {Ticks}
 */
export function readable(ends, length, room) {
  for (let most = 10; most > 3; most--) {
    const found = ticked(ends, most), apart = found.step / (ends[1] - ends[0]) * length;
    if (found.ticks.every(({ text }) => room(text) <= apart)) return found;
  }
  return ticked(ends, 3);
}

/**
 * What an axis is of: a name, and the power of ten of its ticks.
 * @param {string} name
 * @param {number} power
 */
export function titled(name, power) {
  if (!power) return name;
  const raised = String(Math.abs(power)).replace(/\d/g, (digit) => RAISED[Number(digit)]);
  return `${name} in 10${power < 0 ? "⁻" : ""}${raised}`;
}
