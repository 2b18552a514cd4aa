// What the criteria say in each pixel of a chart, proved from values and their errors.
import { Rows, SLACK } from "./programs.js";

export const STABLE = 1, UNSTABLE = 2, OPEN = 3, NOWHERE = 4, UNKNOWN = 0;

/**
 * A condition: the places of its margin and of its even factors.
 * @typedef {{ margin: number, strict: boolean, degenerate: number[] }} Condition
 */
/**
 * What decides in the plane of two names: what must be positive, and the two criteria.
 * @typedef {{ steps: import("./programs.js").Step[], positive: number[], sufficient: Condition[][],
 *   necessary: Condition[][] }} Chart
 */
/** @typedef {[from: number, to: number]} Ends */

/**
 * A disjunction of conjunctions of conditions: 1, -1, or 0 for unknown. A strict condition needs its even factors too,
 * one that is not is met where one of them may be 0.
 * @param {Condition[][]} alternatives
 * @param {Map<number, number>} signs of each place 1, -1, 0
 */
function criterion(alternatives, signs) {
  return Math.max(-1, ...alternatives.map((conditions) => Math.min(1, ...conditions.map(
    ({ margin, strict, degenerate }) => {
      const sign = signs.get(margin) ?? 0, factors = degenerate.map((place) => Math.abs(signs.get(place) ?? 0));
      return strict ? Math.min(sign, ...factors) : factors.includes(0) ? Math.max(sign, 0) : sign;
    }))));
}

/** One code for each pixel, the lowest row first. */
export class Regions {
  /**
   * @param {Chart} chart
   * @param {string[]} axes the names across and upwards
   * @param {number} size pixels of a row, and rows
   */
  constructor(chart, axes, size) {
    this.chart = chart;
    this.axes = axes;
    this.size = size;
    this.rows = new Rows(chart.steps, axes, size);
    this.codes = new Uint8Array(size * size);
    const asked = [...chart.sufficient, ...chart.necessary].flat().flatMap((c) => [c.margin, ...c.degenerate]);
    this.places = [...new Set([...chart.positive, ...asked])];
    this.next = [-1, -1, -1];                           // a tree of the signs met: after node n, of -1, 0 and 1
    /** @type {number[]} */
    this.meaning = [];                                  // of its leaves the codes
    this.node = new Int32Array(size);
  }

  /**
   * @param {Record<string, number>} numbers of the other names
   * @param {Ends[]} ends of the axes; a pixel stands for its centre
   */
  drawn(numbers, [[left, right], [low, high]]) {
    const { rows, size, codes } = this;
    /** @type {(from: number, to: number) => Float64Array} */
    const place = (from, to) => Float64Array.from({ length: size }, (_, n) => from + (to - from) * (n + 0.5) / size);
    rows.begin({ ...numbers, [this.axes[0]]: place(left, right) }, Math.max(Math.abs(low), Math.abs(high)));
    place(low, high).forEach((y, n) => {
      const row = codes.subarray(n * size, (n + 1) * size);
      if (rows.polynomial) {
        rows.row(y, false);
        this.coded(row, false);
      }
      if (!rows.polynomial || row.includes(UNKNOWN)) {
        rows.row(y, true);
        this.coded(row, true);
      }
    });
    return codes;
  }

  /**
   * The codes of a row.
   * @param {Uint8Array} row
   * @param {boolean} each whether each value has an error of its own
   */
  coded(row, each) {
    const { node, places, meaning } = this;
    node.fill(0);
    for (const place of places) this.follow(place, each);
    for (let i = 0; i < row.length; i++) row[i] = meaning[node[i]] ?? (meaning[node[i]] = this.code(node[i]));
  }

  /**
   * One step down the tree, by the sign at a place.
   * @param {number} place
   * @param {boolean} each
   */
  follow(place, each) {
    const { rows: { values, errors, bounds }, node, next } = this;
    const value = values[place], error = each ? errors[place] : [bounds[place]];
    const step = value.length > 1 ? 1 : 0, along = error.length > 1 ? 1 : 0;
    for (let i = 0, p = 0, q = 0; i < node.length; i++, p += step, q += along) {
      const bound = error[q] * SLACK, sign = value[p] > bound ? 2 : value[p] < -bound ? 0 : 1;
      const branch = 3 * node[i] + sign;
      if (next[branch] < 0) {
        next[branch] = next.length / 3;
        next.push(-1, -1, -1);
      }
      node[i] = next[branch];
    }
  }

  /**
   * What a leaf means, whose signs are those on the way to it.
   * @param {number} leaf
   */
  code(leaf) {
    const { chart, places, next } = this;
    /** @type {Map<number, number>} */
    const signs = new Map();
    for (const place of places.toReversed()) {
      const branch = next.indexOf(leaf);
      signs.set(place, branch % 3 - 1);
      leaf = Math.floor(branch / 3);
    }
    const positive = chart.positive.map((place) => signs.get(place));
    if (positive.includes(-1)) return NOWHERE;
    const sufficient = criterion(chart.sufficient, signs), necessary = criterion(chart.necessary, signs);
    if (positive.includes(0)) return UNKNOWN;
    if (sufficient === 1) return STABLE;
    if (necessary === -1) return UNSTABLE;
    return sufficient === -1 && necessary === 1 ? OPEN : UNKNOWN;
  }
}
