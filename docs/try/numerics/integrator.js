// Motions by extrapolation: Gragg's rule with 2, 4, …, 16 steps, extrapolated to none (Hairer, Nørsett & Wanner,
// Solving Ordinary Differential Equations I, II.9), the step chosen so that the last two differ by less than asked.
const ROWS = 8;

// Gragg's rule: n steps over H.
function midpoint(rate, state, H, n) {
  const h = H / n;
  let before = state, here = rate(state).map((r, i) => state[i] + h * r);
  for (let m = 1; m < n; m++) {
    const rates = rate(here);
    [before, here] = [here, before.map((x, i) => x + 2 * h * rates[i])];
  }
  return here;
}

// The state after H, and how far the last two extrapolations are apart.
function extrapolated(rate, state, H) {
  let row = [];
  for (let k = 0; k < ROWS; k++) {
    const next = [midpoint(rate, state, H, 2 * (k + 1))];
    for (let j = 1; j <= k; j++) {
      const ratio = ((k + 1) / (k + 1 - j)) ** 2 - 1;
      next.push(next[j - 1].map((x, i) => x + (x - row[j - 1][i]) / ratio));
    }
    if (k === ROWS - 1) {
      return [next[k], Math.max(...next[k].map((x, i) => Math.abs(x - next[k - 1][i])))];
    }
    row = next;
  }
}

// A motion: at(t) for growing t. rate: of a state; tolerance: of a step.
export class Motion {
  constructor(rate, state, tolerance = 1e-13) {
    Object.assign(this, { rate, state, tolerance, time: 0, step: 0.1 });
  }

  at(time) {
    while (this.time < time) {
      const last = this.time + this.step >= time, H = last ? time - this.time : this.step;
      const [state, error] = extrapolated(this.rate, this.state, H);
      const scale = this.tolerance * Math.max(1, ...state.map(Math.abs));
      const factor = Math.min(4, Math.max(0.1, 0.8 * (scale / (error || 1e-300)) ** (1 / (2 * ROWS - 1))));
      if (error <= scale || H < 1e-12) {
        this.state = state;
        this.time = last ? time : this.time + H;
        if (!last || factor < 1) this.step = H * factor;
      } else this.step = H * factor;
      if (!state.every(Number.isFinite)) throw new Error("the motion leaves the numbers");
    }
    return this.state;
  }
}
