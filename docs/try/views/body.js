// The body as it moves near the equilibrium, seen from outside; its numbers in doubles.
import { principal, turned, unit, UNTURNED } from "../numerics/attitude.js";
import { attitudeAt, Flight, followed, momentum, programs, released } from "../numerics/flight.js";
import { possible } from "../app/numbers.js";
import { names } from "../app/state.js";
import { sliders } from "./sliders.js";
import { paint } from "./body-picture.js";
import { DARK, LIGHT } from "./colours.js";
import { solid } from "./solids.js";

const VIEW = [0.6, 0.38], PIECE = 60, PIECES = 30;      // samples of a piece of the path, and how many pieces
const FRAMES = 240, STRIDE = 4, AHEAD = 60;             // frames to the shortest period; of what is to come every fourth
const PATIENCE = 150;                                   // milliseconds for which an old verdict is left on the path
const WORK = 4;                                         // milliseconds of a frame for what is to come
const KEYS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
const short = (x) => x.toFixed(6).replace(/^-(0\.0+)$/, "$1");

export class Nearby {
  /**
   * @param {Element} place the section
   * @param {import("../app/scene.js").Asked} asked
   * @param {import("../app/answers.js").Answers} answers
   * @param {() => void} changed called when a number is set
   * @param {() => void} settled called when something has come
   */
  constructor(place, asked, answers, changed, settled) {
    Object.assign(this, { place, asked, answers, changed, settled, view: [...VIEW], current: true, names: [], verdict: "",
      wheel: 0, given: {}, flight: null });
    const find = (name) => place.querySelector(name);
    [this.canvas, this.push, this.button, this.more, this.why, this.state, this.drawn, this.caption] = ["canvas",
      "#push", "button", "#more", "#no-motion", "#state", ".drawn", "#seen"].map(find);
    this.context = this.canvas.getContext("2d");
    this.push.oninput = () => {
      asked.push = find("#turned").textContent = this.push.value;
      settled();
    };
    new IntersectionObserver((entries) => { this.seen = entries.at(-1).isIntersecting; }).observe(this.canvas);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    this.button.onclick = () => this.run(!this.running);
    const dark = matchMedia("(prefers-color-scheme: dark)");
    this.colours = () => dark.matches ? DARK : LIGHT;
    dark.onchange = () => this.draw();
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.hands();
  }

  // A drag turns the view, a vertical one by a finger scrolls the page.
  hands() {
    const { canvas } = this;
    let from = null;
    canvas.onpointerdown = (event) => {
      canvas.setPointerCapture(event.pointerId);
      from = [event.clientX, event.clientY];
    };
    canvas.onpointermove = ({ pointerType, clientX, clientY }) => {
      if (!from) return;
      this.turn((clientX - from[0]) / 150, pointerType === "touch" ? 0 : (clientY - from[1]) / 150);
      from = [clientX, clientY];
    };
    canvas.onpointerup = canvas.onpointercancel = () => { from = null; };
    canvas.ondblclick = () => this.look(VIEW);
    canvas.onkeydown = (event) => {
      if (event.key !== "0" && !KEYS[event.key]) return;
      event.preventDefault();
      if (event.key === "0") this.look(VIEW);
      else this.turn(...KEYS[event.key]);
    };
  }

  // Whether the motion is of another scene than the page's, or of other numbers.
  get waiting() {
    return this.answers.waiting("moving") || this.reading || !this.current;
  }

  // Drawn from what is asked and answered; reading: whether the library is still reading the numbers.
  follow(reading) {
    const { asked, answers } = this, { answer, asked: program } = answers.answered.moving ?? {};
    this.reading = false;
    if (answers.waiting("moving")) return this.stop();
    if (program !== this.loaded) this.load(answer, program);
    this.decided();
    const numbers = this.names.map((name) => [name, possible(name, asked.values[name])]);
    const unread = numbers.some(([, value]) => !Number.isFinite(value));
    this.reading = unread && reading;
    if (this.reading) return this.stop();
    const started = JSON.stringify([numbers, asked.push]);
    if (started === this.started) return;
    this.started = started;
    if (!answer) this.refuse("no motion: the scene has no answer");
    else if (unread) this.refuse(answer.why ?? "a motion needs numbers, and possible ones");
    else this.restart(Object.fromEntries(numbers), answer.why ?? answer.error);
  }

  // The verdict gives the path its colour; an old one, of other numbers, for a moment only.
  decided() {
    clearTimeout(this.old);
    const found = this.answers.answered.decided;
    const set = (verdict) => {
      if (verdict === this.verdict) return;
      this.verdict = verdict;
      this.draw();
    };
    if (this.answers.waiting("decided")) this.old = setTimeout(() => set(""), PATIENCE);
    else set(found?.answer.verdict ?? "");
  }

  // Equations, or none; the numbers that a verdict does not need have sliders of their own.
  load(found, program) {
    this.stop();
    this.loaded = program;
    this.names = names(found);
    const beside = names(this.answers.answered.analysed?.answer);
    const given = (found?.names ?? []).filter(({ name }) => !beside.includes(name));
    sliders(this.more, given, this.asked, this.changed);
    this.given = { coordinates: found?.coordinates ?? [], ...programs(found) };
    this.verdict = "";
    this.attitude = undefined;
    this.body = null;
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  stop() {
    this.flight = this.started = null;
    this.current = true;                                // there is nothing to be drawn
    cancelAnimationFrame(this.frame);
  }

  // Nothing is drawn, and why.
  refuse(why) {
    this.stop();
    this.body = null;
    this.why.textContent = why;
    this.drawn.hidden = true;
  }

  // The body at other numbers: from the equilibrium a little turned, or at rest where it cannot move.
  restart(numbers, why = "") {
    const { given } = this, rotor = given.rotor?.(numbers) ?? [0, 0, 0], tensor = given.inertia?.(numbers) ?? [NaN];
    const body = principal(tensor);
    if (!tensor.every(Number.isFinite) || !body.moments.every((moment) => moment > 0)) {
      return this.refuse(why || "a motion needs a body: its moments are positive");
    }
    const here = given.state?.(numbers) ?? [], up = here.length ? here.slice(-3) : [0, 0, 1];
    const exists = here.every(Number.isFinite) && Math.hypot(...up) > 0;
    if (!exists) why ||= "a motion needs an equilibrium that exists at these numbers";
    this.body = { ...body, rotor, solid: solid(body.moments) };
    this.count = exists ? here.length : 0;
    this.tip = followed(body, exists ? unit(up) : up);
    this.flight = null;
    if (why) this.attitude = this.count ? attitudeAt(here, rotor) : UNTURNED;
    else {
      this.flight = new Flight(given, numbers, released(here, Number(this.asked.push)), rotor, this.attitude);
      this.coming = this.flight.again(1e-9);
    }
    this.pieces = [[]];
    this.ahead = [];
    this.current = false;
    this.why.textContent = why;
    this.drawn.hidden = false;
    this.button.hidden = Boolean(why);
    if (why) this.state.textContent = "";
    this.arrived();
    this.describe();
    this.run(this.running);
  }

  // What is drawn of a state with its quaternion: a tip in space, or the momentum of a free body in its axes.
  point(x) {
    if (this.count === 3) return unit(momentum(x, this.body.rotor));
    return turned(this.flight.attitudeOf(x), this.body.axes[this.tip]);
  }

  // The body has come to where its motion is.
  arrived() {
    if (!this.flight) return;
    this.attitude = this.flight.attitude;
    const point = this.point(this.flight.motion.state), piece = this.pieces.at(-1);
    piece.push(point);
    if (piece.length > PIECE) this.pieces.push([point]);
    if (this.pieces.length > PIECES) this.pieces.shift();
  }

  // So many frames on; the wheel turns as its momentum says, but never so fast that it seems to stand.
  step(frames) {
    const { flight, body } = this, pace = flight.period / FRAMES;
    flight.motion.at(flight.time + frames * pace);
    this.arrived();
    const long = Math.hypot(...body.rotor);
    if (long) this.wheel += 0.25 * frames * Math.tanh(8 * pace * long / Math.max(...body.moments));
  }

  // What is to come, as far as there is time for it now.
  foresee() {
    const { flight, coming, ahead } = this, until = performance.now() + WORK, stride = flight.period * STRIDE / FRAMES;
    while (ahead.length && ahead[0].time <= flight.time) ahead.shift();
    while (ahead.length < AHEAD && performance.now() < until) {
      ahead.push({ point: this.point(coming.at(coming.time + stride)), time: coming.time });
      if (coming.time <= flight.time) ahead.pop();
    }
  }

  // A picture for each frame while it runs, or until it is whole.
  run(on) {
    this.running = on;
    this.button.textContent = on ? "Pause" : "Go on";
    cancelAnimationFrame(this.frame);
    let last;
    const next = (now) => {
      try {
        if (this.flight && this.seen) {
          if (this.running) this.step(Math.min(3, (now - (last ?? now - 1000 / 60)) * 60 / 1000));
          this.foresee();
        }
        last = now;
        if (this.seen || !this.current) this.draw();    // what is out of sight may come into it
      } catch (error) {
        this.flight = null;
        this.why.textContent = error.message;
        this.button.hidden = true;
      }
      if (this.flight && (this.running || this.ahead.length < AHEAD)) this.frame = requestAnimationFrame(next);
    };
    this.frame = requestAnimationFrame(next);
  }

  turn(across, up) {
    this.look([this.view[0] + across, Math.max(-1.5, Math.min(1.5, this.view[1] + up))]);
  }

  look(view) {
    this.view = [...view];
    this.draw();
  }

  // What stands still.
  get frameAxes() {
    const names = { 3: ["", "", "M"], 6: ["", "", "k"], 9: ["roll t", "pitch n", "yaw r"] }[this.count] ?? [];
    return names.map((name, n) => ({ direction: UNTURNED[n], name })).filter(({ name }) => name);
  }

  /** @returns {import("./body-picture.js").Picture} */
  get picture() {
    const { body, pieces, ahead } = this, long = Math.hypot(...body.rotor);
    return {
      solid: body.solid, axes: body.axes, attitude: this.attitude, frame: this.frameAxes, verdict: this.verdict,
      view: this.view, rotor: long ? { axle: unit(body.rotor), angle: this.wheel } : null,
      path: { axes: this.count === 3 ? this.attitude : UNTURNED, past: pieces,
        age: pieces.map((_, n) => (pieces.length - 1 - n) / PIECES),
        ahead: [...pieces.at(-1).slice(-1), ...ahead.map(({ point }) => point)] } };
  }

  draw() {
    if (!this.body) return;
    if (!this.current) {
      this.current = true;
      this.settled();
    }
    const { canvas, context } = this, sharp = devicePixelRatio, size = canvas.clientWidth;
    if (canvas.width !== Math.round(size * sharp)) canvas.width = canvas.height = Math.round(size * sharp);
    context.setTransform(sharp, 0, 0, sharp, 0, 0);
    context.clearRect(0, 0, size, size);
    paint(context, size, this.picture, this.colours());
    if (this.flight) this.say();
  }

  // Where the motion is.
  say() {
    this.state.textContent = `t = ${short(this.flight.time)}: (${this.given.coordinates.slice(-3).join(", ")}) = `
      + `(${this.flight.state.slice(-3).map(short).join(", ")})`;
  }

  // What is drawn.
  describe() {
    const { body, count, tip } = this, still = { 3: "the angular momentum M stands still",
      6: "the vertical k stands still", 9: "the axes of the orbit stand still, t along the velocity, n its normal, r away from the Earth" }[count];
    const shape = body.solid.kind === "box" ? "The homogeneous box with these moments"
      : "No body has these moments; drawn is the ellipsoid of inertia, I₁x² + I₂y² + I₃z² = 1";
    const path = count === 3 ? "The path is that of M as the body sees it" : `The path is that of the tip of e${"₁₂₃"[tip]}`;
    this.caption.textContent = [shape + (still ? `; ${still}` : ""),
      ...Math.hypot(...body.rotor) ? ["The wheel stands for the rotor, about l"] : [], ...this.flight ? [path] : []]
      .join(". ") + ".";
  }
}
