// Motions by extrapolation: Gragg's rule with 2, 4, … steps, extrapolated to none (Hairer, Nørsett & Wanner,
// Solving Ordinary Differential Equations I, II.9); a step is such that the last two differ by less than asked.

/** @typedef {(state: number[]) => number[]} Rate a new array of each state */

/**
 * Gragg's rule: n steps over H.
 * @param {Rate} rate
 * @param {number[]} state
 * @param {number[]} rates at the state
 * @param {number} H
 * @param {number} n
 */
function midpoint(rate, state, rates, H, n) {
  const h = H / n;
  let before = state, here = state.map((x, i) => x + h * rates[i]);
  for (let m = 1; m < n; m++) {
    const next = rate(here);
    for (let i = 0; i < next.length; i++) next[i] = before[i] + 2 * h * next[i];
    [before, here] = [here, next];
  }
  return here;
}

/**
 * The state after H, and how far the last two extrapolations are apart.
 * @param {Rate} rate
 * @param {number[]} state
 * @param {number} H
 * @param {number} rows
 * @returns {[number[], number]}
 */
function extrapolated(rate, state, H, rows) {
  const rates = rate(state);
  /** @type {number[][]} */
  let row = [];
  for (let k = 0; k < rows; k++) {
    const next = [midpoint(rate, state, rates, H, 2 * (k + 1))];
    for (let j = 1; j <= k; j++) {
      const ratio = ((k + 1) / (k + 1 - j)) ** 2 - 1;
      next.push(next[j - 1].map((x, i) => x + (x - row[j - 1][i]) / ratio));
    }
    row = next;
  }
  const [last, best] = row.slice(-2);
  return [best, Math.max(...best.map((x, i) => Math.abs(x - last[i])))];
}

// A motion: at(t) for growing t.
export class Motion {
  /**
   * @param {Rate} rate
   * @param {number[]} state
   * @param {number} tolerance of a step
   * @param {number} rows how often Gragg's rule is used for a step
   */
  constructor(rate, state, tolerance = 1e-13, rows = 8) {
    this.rate = rate;
    this.state = state;
    this.tolerance = tolerance;
    this.rows = rows;
    this.time = 0;
    this.step = 0.1;
  }

  /** @param {number} time */
  at(time) {
    while (this.time < time) {
      const last = this.time + this.step >= time, H = last ? time - this.time : this.step;
      const [state, error] = extrapolated(this.rate, this.state, H, this.rows);
      if (!state.every(Number.isFinite)) {              // the step was too long, or the motion ends
        if (H < 1e-12) throw new Error("the motion leaves the numbers");
        this.step = H / 10;
        continue;
      }
      const scale = this.tolerance * Math.max(1, ...state.map(Math.abs));
      const factor = Math.min(4, Math.max(0.1, 0.8 * (scale / (error || 1e-300)) ** (1 / (2 * this.rows - 1))));
      if (error <= scale || H < 1e-12) {
        this.state = state;
        this.time = last ? time : this.time + H;
        if (!last || factor < 1) this.step = H * factor;
      } else this.step = H * factor;
    }
    return this.state;
  }
}
