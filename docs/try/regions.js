// What the criteria say in each pixel of a chart, proved from values and their errors.
import { Rows } from "./programs.js";

export const STABLE = 1, UNSTABLE = 2, OPEN = 3, NOWHERE = 4, UNKNOWN = 0;
const SLACK = 1 + 2 ** -20;                             // what the errors themselves lose by rounding

// Answers are 1, -1, and 0 for unknown: of a margin whether it is positive, of a factor whether it is not 0.
function answers({ values, errors, bounds }, place, each, nonzero, out) {
  const value = values[place], error = errors[place], step = value.length > 1 ? 1 : 0;
  for (let i = 0, p = 0; i < out.length; i++, p += step) {
    const bound = (each ? error[p] : bounds[place]) * SLACK;
    const sign = value[p] > bound ? 1 : value[p] < -bound ? -1 : 0;
    out[i] = nonzero ? Math.abs(sign) : sign;
  }
}

// A disjunction of conjunctions of conditions, a strict one with its even factors, one that is not without.
function criterion(rows, alternatives, each, width) {
  const some = new Int8Array(width).fill(-1), every = new Int8Array(width), one = new Int8Array(width);
  const held = new Int8Array(width);
  for (const conditions of alternatives) {
    every.fill(1);
    for (const { margin, strict, degenerate } of conditions) {
      answers(rows, margin, each, false, held);
      for (const factor of degenerate) {
        answers(rows, factor, each, true, one);
        for (let i = 0; i < width; i++) {
          if (strict) held[i] = Math.min(held[i], one[i]);
          else if (!one[i]) held[i] = Math.max(held[i], 0);
        }
      }
      for (let i = 0; i < width; i++) every[i] = Math.min(every[i], held[i]);
    }
    for (let i = 0; i < width; i++) some[i] = Math.max(some[i], every[i]);
  }
  return some;
}

// One code for each pixel, the lowest row first; ends are those of the pixels' centres.
export class Regions {
  constructor(chart, axes, size) {
    Object.assign(this, { chart, axes, size });
    this.rows = new Rows(chart.steps, axes, size);
    this.codes = new Uint8Array(size * size);
    this.sign = new Int8Array(size);
  }

  drawn(numbers, [[left, right], [low, high]]) {
    const { rows, size, codes } = this;
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

  // The codes of a row, from an error of each value or from one of all.
  coded(row, each) {
    const { rows, size, chart, sign } = this;
    const sufficient = criterion(rows, chart.sufficient, each, size);
    const necessary = criterion(rows, chart.necessary, each, size);
    for (let i = 0; i < size; i++) {
      row[i] = sufficient[i] === 1 ? STABLE : necessary[i] === -1 ? UNSTABLE
        : sufficient[i] === -1 && necessary[i] === 1 ? OPEN : UNKNOWN;
    }
    for (const margin of chart.positive) {
      answers(rows, margin, each, false, sign);
      for (let i = 0; i < size; i++) {
        if (sign[i] === -1) row[i] = NOWHERE;
        else if (sign[i] === 0 && row[i] !== NOWHERE) row[i] = UNKNOWN;
      }
    }
  }
}
