// A body in space: from the library's programs its tensor, its state and its motion, with the attitude beside them.
import { cross, dot, principal, quaternion, rotation, turned, turning, unit, upright, broughtNear } from "./attitude.js";
import { Motion } from "./integrator.js";
import { compiled } from "./programs.js";

/** @typedef {import("./attitude.js").Vector} Vector */
/** @typedef {import("./attitude.js").Matrix} Matrix */
/** @typedef {Record<string, number>} Numbers */

/** @param {number[]} x @param {number} axis @param {number} angle @returns {Vector} turned about an axis */
function about(x, axis, angle) {
  const [b, c] = [x[(axis + 1) % 3], x[(axis + 2) % 3]], found = /** @type {Vector} */ ([...x]);
  found[(axis + 1) % 3] = Math.cos(angle) * b - Math.sin(angle) * c;
  found[(axis + 2) % 3] = Math.sin(angle) * b + Math.cos(angle) * c;
  return found;
}

/**
 * What the library gives of a motion, its programs ready to run; of what it does not give, nothing.
 * @param {any} found
 */
export function programs(found) {
  /** @type {Record<string, (numbers: Numbers) => number[]>} */
  const ready = {};
  for (const key of ["inertia", "rotor", "state", "velocity", "rates"]) if (found?.[key]) ready[key] = compiled(found[key]);
  return ready;
}

/**
 * The state of the equilibrium; its directions turned by so much, or of a free body its momentum, about the axis that is
 * nearest to being across.
 * @param {number[]} state
 * @param {number} push in rad
 */
export function released(state, push) {
  const last = state.length - 3, quiet = state.slice(last).map(Math.abs), axis = quiet.indexOf(Math.min(...quiet));
  const found = [...state];
  for (let n = last ? 3 : 0; n <= last; n += 3) found.splice(n, 3, ...about(found.slice(n, n + 3), axis, push));
  return found;
}

/**
 * The attitude at a state: the direction of the field, or the angular momentum of a free body, points up; in orbit the
 * axes of space are those of roll, pitch and yaw, t, n and r.
 * @param {number[]} state
 * @param {number[]} rotor
 */
export function attitudeAt(state, rotor) {
  if (state.length === 9) return upright(state.slice(6), state.slice(3, 6));
  return upright(state.length === 6 ? state.slice(3) : momentum(state, rotor));
}

/** @param {number[]} state @param {number[]} rotor @returns {Vector} M = π + l */
export const momentum = (state, rotor) => [state[0] + rotor[0], state[1] + rotor[1], state[2] + rotor[2]];

/**
 * The largest modulus of an eigenvalue of a field's derivative: its 32nd power has about this to the 32nd, in any norm.
 * @param {(state: number[]) => number[]} rate
 * @param {number[]} state
 */
export function fastest(rate, state) {
  const columns = state.map((entry, j) => {
    const h = 1e-6 * (1 + Math.abs(entry)), [up, down] = [h, -h].map((step) =>
      rate(state.map((x, i) => i === j ? x + step : x)));
    return up.map((x, i) => (x - down[i]) / (2 * h));
  });
  let matrix = state.map((_, i) => columns.map((column) => column[i])), logarithm = 0;
  for (let n = 0; n < 6; n++) {
    const size = Math.hypot(...matrix.flat());
    if (!size) return 0;
    logarithm += Math.log(size) / 2 ** n;
    if (n === 5) break;
    const scaled = matrix.map((row) => row.map((x) => x / size));
    matrix = scaled.map((row) => scaled.map((_, j) => row.reduce((sum, x, k) => sum + x * scaled[k][j], 0)));
  }
  return Math.exp(logarithm);
}

export class Flight {
  /**
   * @param {{ coordinates: string[], rates: (numbers: Numbers) => number[], velocity: (numbers: Numbers) => number[] }} given
   * @param {Numbers} numbers
   * @param {number[]} state
   * @param {number[]} rotor
   * @param {Matrix} [near] to which its attitude is brought by a turn about the vertical, where that is free
   */
  constructor({ coordinates, rates, velocity }, numbers, state, rotor, near) {
    const known = { ...numbers }, count = coordinates.length;
    /** @param {number[]} x */
    const rate = (x) => {
      for (let n = 0; n < count; n++) known[coordinates[n]] = x[n];
      return rates(known);
    };
    /** @param {number[]} x of the state and the quaternion */
    const whole = (x) => {
      const found = rate(x);
      found.push(...turning(x.slice(count), velocity(known)));
      return found;
    };
    const start = attitudeAt(state, rotor);
    this.count = count;
    this.rotor = rotor;
    this.whole = whole;
    this.begin = [...state, ...quaternion(near && count < 9 ? broughtNear(start, near) : start)];
    this.motion = new Motion(whole, this.begin);
    const rates0 = fastest(rate, state);
    rate(state);
    this.period = 2 * Math.PI / (Math.max(rates0, Math.hypot(...velocity(known))) || 1);
  }

  /** Another motion from the same start, for what is to come. @param {number} tolerance */
  again(tolerance) {
    return new Motion(this.whole, this.begin, tolerance);
  }

  get time() {
    return this.motion.time;
  }

  get state() {
    return this.motion.state.slice(0, this.count);
  }

  get attitude() {
    return this.attitudeOf(this.motion.state);
  }

  /** @param {number[]} x @returns {Matrix} */
  attitudeOf(x) {
    return rotation(x.slice(this.count));
  }
}

/**
 * The principal axis whose tip is followed: that of revolution, else the one nearest to the vertical.
 * @param {{ moments: Vector, axes: Matrix }} body
 * @param {number[]} up
 */
export function followed({ moments: [A, B, C], axes }, up) {
  const same = [[B, C], [C, A], [A, B]].map(([x, y]) => Math.abs(x - y) < 1e-9 * (x + y));
  if (same.filter(Boolean).length === 1) return same.indexOf(true);
  const near = axes.map((axis) => Math.abs(dot(axis, up)));
  return near.indexOf(Math.max(...near));
}
