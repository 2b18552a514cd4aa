// A motion near the equilibrium, in doubles: the path of a vector on a sphere, as the body sees it.
import { Motion } from "../numerics/integrator.js";
import { possible } from "../app/numbers.js";
import { names } from "../app/state.js";
import { fitted, sliders } from "./sliders.js";
import { compiled } from "../numerics/programs.js";

const SIZE = 400, LONG = 4000, FRAMES = 240;             // points of a path; frames to the longest period

const rotated = ([x, y, z], axis, angle) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [[x, c * y - s * z, s * y + c * z], [c * x + s * z, y, c * z - s * x], [c * x - s * y, s * x + c * y, z]][axis];
};
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
    Object.assign(this, { place, asked, answers, changed, settled, view: [0.5, 0.4], running: true, current: true, names: [] });
    const find = (name) => place.querySelector(name);
    [this.canvas, this.push, this.button, this.more, this.why, this.state, this.drawn] = ["canvas", "#push", "button",
      "#more", "#no-motion", "#state", ".drawn"].map(find);
    this.push.oninput = () => {
      asked.push = find("#turned").textContent = this.push.value;
      settled();
    };
    new IntersectionObserver((entries) => { this.seen = entries.at(-1).isIntersecting; }).observe(this.canvas);
    this.button.onclick = () => this.run(!this.running);
    this.canvas.onpointermove = ({ buttons, movementX, movementY }) => {
      if (buttons) this.turn(movementX / 100, movementY / 100);
    };
    this.canvas.onkeydown = (event) => {
      const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (!turns) return;
      event.preventDefault();
      this.turn(...turns);
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
    const { why, error } = answer ?? { why: "no motion: the scene has no answer" };
    const numbers = this.names.map((name) => [name, possible(name, asked.values[name])]);
    const unread = numbers.some(([, value]) => !Number.isFinite(value));
    this.reading = unread && reading;
    if (why ?? error ?? unread) {
      this.stop();
      return this.reading || this.refuse(why ?? error ?? "a motion needs numbers, and possible ones");
    }
    const started = JSON.stringify([numbers, asked.push]);
    if (started !== this.started) this.restart(Object.fromEntries(numbers));
    this.started = started;
  }

  // Equations, or none; the numbers that a verdict does not need have sliders of their own.
  load(found, program) {
    this.stop();
    this.loaded = program;
    this.names = names(found);
    const beside = names(this.answers.answered.analysed.answer);
    const given = (found?.names ?? []).filter(({ name }) => !beside.includes(name));
    fitted(this.asked, given);
    sliders(this.more, given, this.asked, this.changed);
    if (!found?.rates) return;
    this.coordinates = found.coordinates;
    this.rates = compiled(found.rates);
    this.equilibrium = compiled(found.state);
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  stop() {
    this.motion = this.started = null;
    this.current = true;                                // there is nothing to be drawn
    cancelAnimationFrame(this.frame);
  }

  refuse(text = "") {
    this.why.textContent = text;
    this.drawn.hidden = Boolean(text);
  }

  // From the equilibrium, its directions turned, or of a free body its momentum.
  restart(numbers) {
    const start = this.equilibrium(numbers), last = start.length - 3;
    const at = start.slice(last), quiet = at.map(Math.abs), axis = quiet.indexOf(Math.min(...quiet));
    if (!start.every(Number.isFinite) || !Math.hypot(...at)) {
      this.stop();
      return this.refuse("a motion needs an equilibrium that exists at these numbers");
    }
    this.refuse();
    for (let n = last ? 3 : 0; n <= last; n += 3) {
      start.splice(n, 3, ...rotated(start.slice(n, n + 3), axis, Number(this.asked.push)));
    }
    const rates = this.rates, rate = (state) => rates(Object.assign(numbers, Object.fromEntries(
      this.coordinates.map((name, n) => [name, state[n]]))));
    this.centre = at;
    this.current = false;
    this.motion = new Motion(rate, start);
    this.pace = this.period(rate, start) / FRAMES;
    this.path = [start.slice(last)];
    this.say();
    this.run(this.running);
  }

  // About the time in which the fastest of what is near goes round.
  period(rate, state) {
    const here = rate(state), small = 1e-6;
    const slopes = state.map((_, i) => Math.hypot(...rate(state.map((x, j) => x + (i === j) * small))
      .map((r, j) => (r - here[j]) / small)));
    return 2 * Math.PI / Math.max(...slopes, 1e-3);
  }

  step() {
    this.path.push(this.motion.at(this.motion.time + this.pace).slice(-3));
    if (this.path.length > LONG) this.path.shift();
  }

  // A step for each frame; of a motion that stands still as many as show its path, and no more.
  run(on) {
    this.running = on;
    this.button.textContent = on ? "Pause" : "Go on";
    cancelAnimationFrame(this.frame);
    const next = () => {
      if (!this.motion) return;
      try {
        if (this.seen) this.step();
        if (this.seen || !this.current) this.draw();    // what is out of sight may come into it
      } catch (error) {
        this.motion = null;
        return this.refuse(error.message);
      }
      if (this.running || this.path.length < FRAMES) this.frame = requestAnimationFrame(next);
    };
    this.frame = requestAnimationFrame(next);
  }

  turn(across, up) {
    this.view = [this.view[0] + across, Math.max(-1.5, Math.min(1.5, this.view[1] + up))];
    this.draw();
  }

  draw() {
    if (!this.motion) return;
    if (!this.current) {
      this.current = true;
      this.settled();
    }
    const context = this.canvas.getContext("2d"), radius = 0.45 * SIZE, size = Math.hypot(...this.path[0]);
    const style = getComputedStyle(this.canvas), [turn, tilt] = this.view;
    const seen = ([x, y, z]) => {
      const a = x * Math.cos(turn) - y * Math.sin(turn), b = x * Math.sin(turn) + y * Math.cos(turn);
      return [SIZE / 2 + radius * a, SIZE / 2 - radius * (z * Math.cos(tilt) + b * Math.sin(tilt)),
        b * Math.cos(tilt) - z * Math.sin(tilt)];
    };
    const line = (points, front) => {
      context.beginPath();
      points.forEach((point, n) => {
        const [x, y, depth] = seen(point);
        if (n === 0 || (depth <= 0) !== front) context.moveTo(x, y);
        else context.lineTo(x, y);
      });
      context.stroke();
    };
    context.clearRect(0, 0, SIZE, SIZE);
    context.strokeStyle = style.getPropertyValue("border-color");
    context.lineWidth = 1;
    context.beginPath();
    context.arc(SIZE / 2, SIZE / 2, radius, 0, 7);
    context.stroke();
    const round = Array.from({ length: 121 }, (_, n) => [Math.cos(n * Math.PI / 60), Math.sin(n * Math.PI / 60)]);
    for (const circle of [([c, s]) => [c, s, 0], ([c, s]) => [c, 0, s], ([c, s]) => [0, c, s]]) line(round.map(circle), true);
    const path = this.path.map((point) => point.map((x) => x / size));
    context.strokeStyle = style.color;
    context.globalAlpha = 0.25;
    line(path, false);
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    line(path, true);
    context.fillStyle = style.color;
    for (const [point, wide] of [[path.at(-1), 4], [this.centre.map((x) => x / size), 2]]) {
      const [x, y] = seen(point);
      context.beginPath();
      context.arc(x, y, wide, 0, 7);
      context.fill();
    }
    this.say();
  }

  // Where the motion is.
  say() {
    this.state.textContent = `t = ${short(this.motion.time)}: (${this.coordinates.slice(-3).join(", ")}) = `
      + `(${this.path.at(-1).map(short).join(", ")})`;
  }
}
