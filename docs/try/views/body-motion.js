// The body of a scene at numbers: at rest or in its motion, what is painted of it and what is said of it.
import { principal, turned, unit, UNTURNED } from "../numerics/attitude.js";
import { attitudeAt, Flight, followed, momentum, programs, released } from "../numerics/flight.js";
import { solid } from "./solids.js";

/** @typedef {import("../numerics/attitude.js").Vector} Vector */
/** @typedef {import("../numerics/attitude.js").Matrix} Matrix */
/** @typedef {import("../numerics/flight.js").Numbers} Numbers */
/** @typedef {import("./body-picture.js").Picture} Picture */

/** @type {[number, number]} */
export const VIEW = [0.6, 0.38];                        // from where a body is seen at first
const PIECE = 60, PIECES = 30;                          // samples of a piece of the path, and how many pieces
const FRAMES = 240;                                     // to the shortest period
const STRIDE = 4, AHEAD = 60;                           // frames to a sample of what is to come; samples
const FASTEST = 0.25;                                   // rad of a wheel in a frame; faster it seems to stand
/** @type {Record<number, Picture["frame"]>} */
const FRAME = { 0: [], 3: [{ name: "M", direction: [0, 0, 1] }], 6: [{ name: "k", direction: [0, 0, 1] }],
  9: [{ name: "roll t", direction: [1, 0, 0] }, { name: "pitch n", direction: [0, 1, 0] },
    { name: "yaw r", direction: [0, 0, 1] }, { name: "Earth", direction: [0, 0, -1] }] };
/** @type {Record<number, string>} */
const STILL = { 3: "the angular momentum M stands still", 6: "the vertical k stands still",
  9: "the axes of the orbit stand still: t along the velocity, n across the orbit, r upwards" };
const SUBSCRIPTS = "₁₂₃";

/** @param {number} x */
const short = (x) => x.toFixed(6).replace(/^-(0\.0+)$/, "$1");

export class BodyMotion {
  /** @param {any} found what the library gives of a motion */
  constructor(found) {
    /** @type {string[]} */
    this.coordinates = found?.coordinates ?? [];
    this.programs = programs(found);
    this.refused = found ? found.why ?? found.error ?? "" : "no motion: the scene has no answer";
    this.wheel = this.count = this.followed = 0;
    /** @type {Matrix | undefined} */
    this.attitude = undefined;
    this.rest();
  }

  // Nothing is known.
  rest() {
    /** @type {{ moments: Vector, axes: Matrix, rotor: Vector, solid: import("./solids.js").Solid } | null} */
    this.body = null;
    /** @type {Flight | null} */
    this.flight = null;
    this.count = 0;
    /** @type {Vector[][]} */
    this.pieces = [[]];
    /** @type {{ point: Vector, time: number }[]} */
    this.ahead = [];
  }

  /**
   * The body at other numbers: from the equilibrium a little turned, or at rest where it cannot move. A
   * motion begins as near as can be to the attitude in which the body was.
   * @param {Numbers} numbers
   * @param {number} push in rad
   * @returns {string} why it does not move; "" if it does
   */
  restart(numbers, push) {
    this.rest();
    const { inertia, rotor, state } = this.programs;
    const tensor = inertia?.(numbers) ?? [NaN], body = principal(tensor);
    if (!tensor.every(Number.isFinite) || !body.moments.every((moment) => moment > 0)) {
      return this.refused || "a body has positive moments of inertia";
    }
    const [l1, l2, l3] = rotor(numbers), here = state?.(numbers) ?? [], up = here.slice(-3);
    this.body = { ...body, rotor: [l1, l2, l3], solid: solid(body.moments) };
    if (here.length && here.every(Number.isFinite) && Math.hypot(...up) > 0) {
      this.count = here.length;
      this.followed = followed(body, unit(up));
    }
    const nowhere = this.count ? "" : "a motion needs an equilibrium that exists at these numbers";
    const why = this.refused || nowhere;
    if (why) {
      this.attitude = this.count ? attitudeAt(here, this.body.rotor) : UNTURNED;
      return why;
    }
    const { coordinates, programs: { rates, velocity } } = this;
    this.flight = new Flight({ coordinates, rates, velocity }, numbers, released(here, push), this.body.rotor,
      this.attitude);
    this.coming = this.flight.again();
    this.arrived(this.flight);
    return "";
  }

  /**
   * What is followed of a state: the tip of an axis in space, or the momentum of a free body in its axes.
   * @param {Flight} flight
   * @param {number[]} x with the quaternion
   */
  point(flight, x) {
    if (!this.body) return UNTURNED[2];
    return this.count === 3 ? unit(momentum(x, this.body.rotor))
      : turned(flight.attitudeOf(x), this.body.axes[this.followed]);
  }

  /** @param {Flight} flight */
  arrived(flight) {
    const point = this.point(flight, flight.motion.state), piece = this.pieces[this.pieces.length - 1];
    this.attitude = flight.attitude;
    piece.push(point);
    if (piece.length > PIECE) this.pieces.push([point]);
    if (this.pieces.length > PIECES) this.pieces.shift();
  }

  /** So many frames on. @param {number} frames */
  step(frames) {
    const { flight, body } = this;
    if (!flight || !body) return;
    const pace = flight.period / FRAMES, spin = Math.hypot(...body.rotor) / Math.max(...body.moments);
    flight.motion.at(flight.time + frames * pace);
    this.arrived(flight);
    this.wheel += frames * FASTEST * Math.tanh(8 * spin * pace);
  }

  /**
   * The motion to come, as long as there is time for it.
   * @param {() => boolean} busy
   * @returns {boolean} whether it is known as far as it is drawn
   */
  foresee(busy) {
    const { flight, coming, ahead } = this;
    if (!flight || !coming) return true;
    while (ahead.length && ahead[0].time <= flight.time) ahead.shift();
    while (ahead.length < AHEAD && !busy()) {
      const x = coming.at(coming.time + flight.period * STRIDE / FRAMES);
      if (coming.time > flight.time) ahead.push({ point: this.point(flight, x), time: coming.time });
    }
    return ahead.length === AHEAD;
  }

  /**
   * @param {string} verdict "" of none
   * @param {[number, number]} view
   * @returns {Picture | null} null of no body
   */
  picture(verdict, view) {
    const { body, pieces, ahead, attitude = UNTURNED, count } = this;
    if (!body) return null;
    const last = pieces[pieces.length - 1].slice(-1);
    return { solid: body.solid, axes: body.axes, attitude, frame: FRAME[count], verdict, view,
      rotor: Math.hypot(...body.rotor) ? { axle: unit(body.rotor), angle: this.wheel } : null,
      path: { axes: count === 3 ? attitude : UNTURNED, past: pieces,
        age: pieces.map((_, n) => (pieces.length - 1 - n) / PIECES),
        ahead: [...last, ...ahead.map(({ point }) => point)] } };
  }

  /** Where the motion is; "" at rest. */
  said() {
    if (!this.flight) return "";
    const { time, state } = this.flight, there = state.slice(-3).map(short).join(", ");
    return `t = ${short(time)}: (${this.coordinates.slice(-3).join(", ")}) = (${there})`;
  }

  /** What is drawn. */
  caption() {
    const { body, count, flight } = this;
    if (!body) return "";
    const shape = body.solid.kind === "box" ? "The homogeneous box with these moments"
      : "No body has these moments; drawn is its ellipsoid of inertia, I₁x² + I₂y² + I₃z² = 1";
    const still = count ? `; ${STILL[count]}` : "";
    const wheel = Math.hypot(...body.rotor) ? " The wheel is the rotor, about l." : "";
    const point = count === 3 ? "M as the body sees it" : `the tip of e${SUBSCRIPTS[this.followed]}`;
    return `${shape}${still}.${wheel}${flight ? ` The path is that of ${point}.` : ""}`;
  }
}

/**
 * The picture of a body after some frames, for a page that is not there yet.
 * @param {any} found what the library gives of a motion
 * @param {Numbers} numbers
 * @param {{ push?: number, frames?: number, verdict?: string, view?: [number, number] }} options
 */
export function portrait(found, numbers, { push = 0.05, frames = FRAMES, verdict = "", view = VIEW } = {}) {
  const moved = new BodyMotion(found);
  moved.restart(numbers, push);
  for (let n = 0; n < frames; n++) moved.step(1);
  moved.foresee(() => false);
  return moved.picture(verdict, view);
}
