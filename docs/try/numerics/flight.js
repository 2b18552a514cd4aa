// A body in space: the library's equations of motion, and its attitude, integrated beside them.
import { broughtNear, dot, quaternion, rotation, turning, upright, vector } from "./attitude.js";
import { Motion } from "./integrator.js";
import { compiled } from "./compiled.js";

/** @typedef {import("./attitude.js").Vector} Vector */
/** @typedef {import("./attitude.js").Matrix} Matrix */
/** @typedef {Record<string, number>} Numbers */
/** @typedef {(numbers: Numbers) => number[]} Program */

/** @param {number[]} x @param {number} axis @param {number} angle @returns {Vector} turned about an axis */
function about(x, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle), after = (axis + 1) % 3, last = (axis + 2) % 3;
  return vector((n) => n === after ? c * x[n] - s * x[last] : n === last ? s * x[after] + c * x[n] : x[n]);
}

/**
 * What the library gives of a motion, ready to run; what it does not give is undefined.
 * @param {any} found
 */
export function programs(found) {
  /** @type {(key: string) => any} */
  const ready = (key) => found?.[key] && compiled(found[key]);
  /** @type {{ inertia: Program, rotor: Program, state?: Program, velocity: Program, rates: Program }} */
  const all = { inertia: ready("inertia"), rotor: ready("rotor"), state: ready("state"),
    velocity: ready("velocity"), rates: ready("rates") };
  return all;
}

/**
 * A state with its directions, or the momentum of a free body, turned about the axis that is nearest to across.
 * @param {number[]} state
 * @param {number} push in rad
 */
export function released(state, push) {
  const last = state.length - 3, quiet = state.slice(last).map(Math.abs), found = [...state];
  const axis = quiet.indexOf(Math.min(...quiet));
  for (let n = last ? 3 : 0; n <= last; n += 3) {
    found.splice(n, 3, ...about(found.slice(n, n + 3), axis, push));
  }
  return found;
}

/** @param {number[]} state @param {number[]} rotor @returns {Vector} M = π + l */
export const momentum = (state, rotor) => vector((n) => state[n] + rotor[n]);

/**
 * The attitude at a state: the direction of the field, or the momentum of a free body, points up; in orbit
 * t, n and r are the axes of space.
 * @param {number[]} state
 * @param {number[]} rotor
 */
export function attitudeAt(state, rotor) {
  if (state.length === 9) return upright(state.slice(6), state.slice(3, 6));
  return upright(state.length === 6 ? state.slice(3) : momentum(state, rotor));
}

/**
 * About the largest modulus of an eigenvalue of a field's derivative J, in whatever units: the 32nd root of
 * the norm of its 32nd power.
 * @param {(state: number[]) => number[]} rate
 * @param {number[]} state
 */
export function fastest(rate, state) {
  const columns = state.map((entry, j) => {
    const h = 1e-6 * (1 + Math.abs(entry));
    const [up, down] = [h, -h].map((step) => rate(state.with(j, entry + step)));
    return up.map((x, i) => (x - down[i]) / (2 * h));
  });
  let J = state.map((_, i) => columns.map((column) => column[i])), logarithm = 0;
  for (let n = 0; n < 6; n++) {
    const size = Math.hypot(...J.flat()), scaled = J.map((row) => row.map((x) => x / size));
    if (!size) return 0;
    logarithm += Math.log(size) / 2 ** n;
    J = scaled.map((row) => scaled.map((_, j) => row.reduce((sum, x, k) => sum + x * scaled[k][j], 0)));
  }
  return Math.exp(logarithm);
}

export class Flight {
  /**
   * @param {{ coordinates: string[], rates: Program, velocity: Program }} given
   * @param {Numbers} numbers
   * @param {number[]} state
   * @param {number[]} rotor
   * @param {Matrix} [near] to which the attitude is brought by a turn about the vertical, if that is free
   */
  constructor({ coordinates, rates, velocity }, numbers, state, rotor, near) {
    const known = { ...numbers }, count = coordinates.length, start = attitudeAt(state, rotor);
    /** @param {number[]} x */
    const rate = (x) => {
      for (let n = 0; n < count; n++) known[coordinates[n]] = x[n];
      return rates(known);
    };
    /** @param {number[]} x a state and a quaternion */
    this.rate = (x) => [...rate(x), ...turning(x.slice(count), velocity(known))];
    this.count = count;
    this.start = [...state, ...quaternion(near && count < 9 ? broughtNear(start, near) : start)];
    this.motion = new Motion(this.rate, this.start);
    const quick = fastest(rate, state);
    rate(state);
    this.period = 2 * Math.PI / (Math.max(quick, Math.hypot(...velocity(known))) || 1);
  }

  /** The same motion from its start, quickly and roughly, for what is to come. */
  again() {
    return new Motion(this.rate, this.start, 1e-7, 4);
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

  /** @param {number[]} x */
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
