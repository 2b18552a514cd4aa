// The body as it moves near the equilibrium, seen from outside; its numbers in doubles.
import { possible } from "../app/numbers.js";
import { names } from "../app/state.js";
import { say } from "./blocks.js";
import { BodyMotion, VIEW } from "./body-motion.js";
import { paint } from "./body-picture.js";
import { cleared } from "./canvas.js";
import { DARK, LIGHT } from "./colours.js";
import { turning } from "./hands.js";
import { sliders } from "./sliders.js";

const PATIENCE = 150;                                   // milliseconds of an old verdict on the path
const WORK = 4;                                         // milliseconds of a frame for what is to come
const READ = 100;                                       // milliseconds in which numbers are read
const FRAME = 1000 / 60, LONGEST = 3;                   // milliseconds; as many frames a slow one makes good
const SPARING = 2.5 * FRAME;                            // milliseconds between pictures while files come

export class Nearby {
  /**
   * @param {Element} place the section
   * @param {import("../app/scene.js").Asked} asked
   * @param {import("../app/answers.js").Answers} answers
   * @param {() => void} changed called when a number is set
   * @param {() => void} settled called when the motion is to begin otherwise
   */
  constructor(place, asked, answers, changed, settled) {
    /** @type {(name: string) => any} */
    const find = (name) => place.querySelector(name);
    this.asked = asked;
    this.answers = answers;
    this.changed = changed;
    this.canvas = find("canvas");
    this.button = find("button");
    this.more = find("#more");
    this.why = find("#no-motion");
    this.state = find("#state");
    this.drawn = find(".drawn");
    this.caption = find("#seen");
    this.view = VIEW;
    this.verdict = "";
    this.moved = new BodyMotion(undefined);
    /** @type {string[]} */
    this.names = [];
    /** @type {string | null} */
    this.started = null;
    this.reading = false;
    this.seen = true;
    this.whole = this.fresh = false;
    this.apart = SPARING;                               // milliseconds between pictures
    this.size = this.frame = this.told = this.last = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.old = undefined;
    const push = find("#push");
    push.oninput = () => {
      asked.push = find("#turned").textContent = push.value;
      settled();
    };
    new IntersectionObserver((entries) => {
      this.seen = entries[entries.length - 1].isIntersecting;
    }).observe(this.canvas);
    new ResizeObserver((entries) => {
      this.size = Math.round(entries[entries.length - 1].contentRect.width);
      this.draw();
    }).observe(this.canvas);
    this.button.onclick = () => this.run(!this.running);
    this.dark = matchMedia("(prefers-color-scheme: dark)");
    this.dark.onchange = () => this.draw();
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    turning(this.canvas, (across, up) => this.look([this.view[0] + across,
      Math.max(-1.5, Math.min(1.5, this.view[1] + up))]), () => this.look(VIEW));
  }

  // Whether the motion is of another scene than the page's, or of other numbers.
  get waiting() {
    return this.answers.waiting("moving") || this.reading;
  }

  get colours() {
    return this.dark.matches ? DARK : LIGHT;
  }

  // What is to be painted; null where there is no body.
  get picture() {
    return this.moved.picture(this.verdict, this.view);
  }

  /**
   * Drawn from what is asked and answered.
   * @param {boolean} reading whether the library is still reading the numbers
   */
  follow(reading) {
    const { asked, answers } = this, { answer, asked: program } = answers.answered.moving ?? {};
    this.reading = false;
    if (answers.waiting("moving")) return this.stop();
    if (program !== this.loaded) this.load(answer, program);
    this.decided();
    /** @type {[string, number][]} */
    const numbers = this.names.map((name) => [name, possible(name, asked.values[name])]);
    const unread = numbers.some(([, value]) => !Number.isFinite(value));
    this.reading = unread && reading;
    if (this.reading) return this.stop();
    const started = JSON.stringify([numbers, asked.push]);
    if (started !== this.started) this.restart(unread ? null : Object.fromEntries(numbers));
    this.started = started;
  }

  // The verdict gives the path its colour; an old one, of other numbers, for a moment only.
  decided() {
    /** @param {string} verdict */
    const set = (verdict) => {
      clearTimeout(this.old);
      this.old = undefined;
      if (verdict === this.verdict) return;
      this.verdict = verdict;
      this.draw();
    };
    if (this.answers.waiting("decided")) this.old ??= setTimeout(() => set(""), PATIENCE);
    else set(this.answers.of("decided")?.verdict ?? "");
  }

  /**
   * Another scene; the numbers that a verdict does not need have sliders of their own.
   * @param {any} found
   * @param {string | undefined} program
   */
  load(found, program) {
    this.stop();
    this.loaded = program;
    this.names = names(found);
    const beside = names(this.answers.answered.analysed?.answer);
    /** @type {import("./sliders.js").Name[]} */
    const all = found?.names ?? [], given = all.filter(({ name }) => !beside.includes(name));
    sliders(this.more, given, this.asked, this.changed);
    this.moved = new BodyMotion(found);
    this.verdict = "";
    this.running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  stop() {
    this.started = null;
    this.moved.rest();
  }

  /** @param {Record<string, number> | null} numbers null if some are none */
  restart(numbers) {
    const { moved } = this;
    if (!numbers) this.stop();
    const why = numbers ? moved.restart(numbers, Number(this.asked.push))
      : moved.refused || "a motion needs numbers, and possible ones";
    say(this.why, why);
    say(this.caption, moved.caption());
    this.drawn.hidden = !moved.body;
    this.button.hidden = !moved.flight;
    say(this.state, moved.said());                      // the state of other numbers is not left a moment longer
    this.draw();                                        // also what is out of sight, which may come into it
    this.run(this.running);
  }

  /** A picture for each frame while it runs, or until it is whole. @param {boolean} on */
  run(on) {
    this.running = on;
    this.whole = false;
    this.last = 0;
    say(this.button, on ? "Pause" : "Go on");
    this.wake();
  }

  /**
   * The start of the library needs the machine: the body moves with few pictures while files come, and stands while
   * Python starts.
   * @param {boolean} ready
   * @param {boolean} coming
   */
  spare(ready, coming) {
    this.apart = ready ? 0 : coming ? SPARING : Infinity;
  }

  // The next frame of the screen has something to do.
  wake() {
    this.frame ||= requestAnimationFrame((now) => this.next(now));
  }

  /** One frame: so much further on, and one picture. @param {number} now */
  next(now) {
    const { moved } = this;
    this.frame = 0;
    try {
      if (!this.fresh && now < this.last + this.apart) return this.wake();
      if (moved.flight && this.seen) {
        if (this.running) moved.step(Math.min(LONGEST, this.last ? (now - this.last) / FRAME : 1));
        const until = performance.now() + WORK;
        this.whole = moved.foresee(() => performance.now() > until);
        this.fresh = true;
      }
      this.last = now;
      if (this.fresh) this.paint();
    } catch (error) {
      moved.flight = null;
      say(this.why, /** @type {Error} */ (error).message);
      this.button.hidden = true;
    }
    if (moved.flight && (this.running || !this.whole)) this.wake();
  }

  /** @param {[number, number]} view */
  look(view) {
    this.view = view;
    this.draw();
  }

  // A picture with the next frame, one of all that has changed before it.
  draw() {
    this.fresh = true;
    this.wake();
  }

  paint() {
    const { picture, size, colours } = this;
    this.fresh = false;
    if (!picture || !size) return;
    paint(cleared(this.canvas, size), size, picture, colours);
    if (this.running && this.moved.flight && performance.now() < this.told + READ) return;
    this.told = performance.now();
    say(this.state, this.moved.said());
  }
}
