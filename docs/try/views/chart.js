// A chart of two names: in each pixel what doubles prove of the criteria, over it zeros of margins, exact.
import { notice, reload } from "../app/notices.js";
import { possible } from "../app/numbers.js";
import { paired } from "./axes.js";
import { element, say } from "./blocks.js";
import { cleared } from "./canvas.js";
import { handled } from "./chart-hands.js";
import { paint, placed, shares } from "./plot.js";
import { Regions, SIZE } from "./regions.js";
import { rounded, stretched, written } from "./scales.js";

/** @typedef {import("./scales.js").Scale} Scale */
/** @typedef {import("./plot.js").Plot} Plot */

const STEPS = 100;                                      // of an arrow key, from end to end
// the swatches of the key, in the order of their codes in numerics/regions.js
const COLOURS = ["unknown", "stable", "unstable", "open", "nowhere"];

export class Chart {
  /**
   * @param {HTMLElement} place the section
   * @param {import("../app/scene.js").Asked} asked
   * @param {import("../app/answers.js").Answers} answers
   * @param {(name: string, text: string) => void} set sets a number of the page
   * @param {() => void} settled called when something has come, another axis is chosen or the ends are others
   */
  constructor(place, asked, answers, set, settled) {
    this.place = place;
    this.asked = asked;
    this.answers = answers;
    this.set = set;
    this.settled = settled;
    /** @type {string[]} the axes of a link */
    this.wanted = [];
    /** @type {any} */
    this.program = null;
    this.drawing = this.broken = "";
    this.size = 0;                                      // of the picture, a square, where it is or was last seen
    /** @type {import("./plot.js").Colours} */
    this.colours = { ink: "", quiet: "", paper: "" };
    /** @param {string} name @returns {any} */
    const find = (name) => place.querySelector(name);
    this.canvas = find("canvas");
    this.selects = [find("#across"), find("#upwards")];
    this.choice = find(".axes");
    this.why = find("#no-chart");
    this.drawn = find(".drawn");
    this.whole = find("#whole");
    this.ends = find("#ends");
    this.regions = new Regions(settled, (why) => {
      this.broken = "no chart, see the top of this page";
      notice("chart", `The chart failed (${why}).`, ...reload);
      settled();
    });
    this.selects.forEach((select, n) => { select.onchange = () => this.turned(n); });
    this.whole.onclick = () => this.rescaled((scale) => ({ ...scale, ends: scale.whole }));
    handled(this.canvas, {
      point: () => this.point(),
      within: (at) => shares(this.size, at).every((share) => share >= 0 && share <= 1),
      set: (at) => this.to(shares(this.size, at)),
      step: (at, step) => this.to(shares(this.size, at).map((share, n) => share + step[n] / STEPS)),
      stretch: (from, to, factor) => this.stretch(shares(this.size, from), shares(this.size, to), factor) });
    this.inks();
    matchMedia("(prefers-color-scheme: dark)").onchange = () => {
      this.inks();
      settled();
    };
    new ResizeObserver((entries) => {
      this.size = Math.round(entries[entries.length - 1].contentRect.width) || this.size;
      this.draw();
    }).observe(this.canvas);
    addEventListener("resize", () => this.draw());      // a pixel of the screen may be another one
  }

  /** Whether what is drawn is of another scene than the page's, or of other numbers. */
  get waiting() {
    return this.answers.waiting("charted") || this.regions.waiting;
  }

  /**
   * Another equilibrium: of its names two that differ, the old ones or those of a link if they are among
   * them.
   * @param {string[]} axes
   * @param {import("./scales.js").Name[]} names
   */
  choose(axes, names) {
    const texts = new Map(names.map(({ name, text }) => [name, text]));
    this.asked.axes = paired(axes, this.asked.axes.map((name, n) => this.wanted[n] ?? name));
    this.wanted = [];
    this.selects.forEach((select, n) => {
      select.replaceChildren(...axes.map((axis) => new Option(texts.get(axis), axis)));
      select.value = this.asked.axes[n];
    });
    this.choice.hidden = axes.length < 2;
  }

  /** Another axis; the name of the other one changes places with it. @param {number} n */
  turned(n) {
    const { selects, asked } = this;
    if (selects[n].value === asked.axes[1 - n]) selects[1 - n].value = asked.axes[n];
    asked.axes = selects.map((select) => select.value);
    this.settled();
  }

  /**
   * Drawn from what is asked and answered.
   * @param {boolean} reading whether the library still reads numbers
   */
  follow(reading) {
    const { asked: { axes }, answers, regions } = this, { answer, asked } = answers.answered.charted ?? {};
    if (answers.waiting("charted")) return;
    if (asked !== regions.loaded) {
      this.program = answer?.steps ? answer : null;
      regions.load(this.program, axes, asked);
    }
    /** @type {[string, number][]} */
    const needed = (this.program?.names ?? []).filter((/** @type {string} */ name) => !axes.includes(name))
      .map((/** @type {string} */ name) => [name, this.value(name)]);
    const unread = needed.some(([, value]) => !Number.isFinite(value));
    const refused = this.refused(answer, unread && !reading), ends = this.scales().map((scale) => scale.ends);
    say(this.why, refused);
    this.drawn.hidden = Boolean(refused);
    const zoomed = this.scales().some((scale) => String(scale.ends) !== String(scale.whole));
    this.whole.hidden = Boolean(refused) || !zoomed;
    regions.want(refused ? null : unread ? undefined : { ends, numbers: Object.fromEntries(needed) });
    this.draw();
  }

  /** A number of the page as a double, NaN of one that is none. @param {string} name */
  value(name) {
    return possible(name, this.asked.values[name]);
  }

  /** The scales of the two axes. @returns {Scale[]} */
  scales() {
    return this.asked.axes.flatMap((name) => this.asked.scales.get(name) ?? []);
  }

  /**
   * Why there is no picture; "" if there is one.
   * @param {any} answer
   * @param {boolean} unread
   * @returns {string}
   */
  refused(answer, unread) {
    if (!answer) return "no chart: the scene has no answer";
    const why = this.broken || (answer.why ?? answer.error ?? "");
    if (why) return why;
    if (unread) return "a picture needs numbers, and possible ones";
    return this.regions.colours.length ? "" : "no chart without its colours";
  }

  /**
   * Takes the colours of the page: red, green, blue and 255 of each swatch, none if they are not all
   * different; those of what is drawn over the picture and beside it.
   */
  inks() {
    /** @param {string} place @returns {any} */
    const style = (place) => getComputedStyle(/** @type {Element} */ (this.place.querySelector(place)));
    const colours = COLOURS.map((name) => style(`.key .${name}`).backgroundColor)
      .map((colour) => [...(colour.match(/\d+/g) ?? []).slice(0, 3).map(Number), 255]);
    this.regions.colours = new Set(colours.map(String)).size === COLOURS.length ? colours : [];
    this.colours = { ink: style("canvas").color, quiet: style("#ends").color,
      paper: style(".key .unknown").backgroundColor };
    this.regions.paint(this.regions.image);
    this.drawing = "";
  }

  /** What is drawn. @param {import("./scales.js").Ends[]} ends @param {any} image @returns {Plot} */
  plot(ends, image) {
    const [across, upwards] = this.asked.axes, texts = this.scales().map(({ of }) => of.text);
    return { image, axes: ends.map((pair, n) => ({ text: texts[n], ends: pair })),
      points: this.answers.of("edges")?.points ?? [], here: [this.value(across), this.value(upwards)] };
  }

  draw() {
    const { answers, size, regions: { ends, image, shown } } = this, sharp = devicePixelRatio;
    if (!ends || !size || answers.waiting("charted")) return;
    const plot = this.plot(ends, image);
    const drawing = JSON.stringify([shown, answers.waiting("edges"), plot.here, size, sharp]);
    if (drawing === this.drawing) return;
    this.drawing = drawing;
    paint(cleared(this.canvas, size), size, plot, this.colours);
    this.say(plot);
  }

  /** The same in words. @param {Plot} plot */
  say({ axes: [{ ends: [left, right] }, { ends: [low, high] }], here }) {
    const [across, upwards] = this.asked.axes, error = this.answers.of("edges")?.error;
    say(this.ends, `${across} from ${left} to ${right} across, ${upwards} from ${low} to ${high} upwards`
      + (error ? `; no boundary is drawn: ${error}` : ""));
    this.canvas.ariaLabel = `Chart of the verdict, ${across} across and ${upwards} upwards. The ring is at `
      + `${across} = ${here[0]}, ${upwards} = ${here[1]}. Arrow keys move it, + and - zoom.`;
  }

  /** For a picture of the page: in its colours of this moment; null if there is no chart. */
  printed() {
    const { regions } = this, image = element("canvas", { width: SIZE, height: SIZE });
    if (this.drawn.hidden || !regions.ends) return null;
    this.inks();
    regions.paint(image);
    const plot = this.plot(regions.ends, image), { colours } = this;
    return { width: SIZE, height: SIZE, draw: (/** @type {any} */ to) => paint(to, SIZE, plot, colours) };
  }

  /** Where the ring is in the picture; null if it is not on it. @returns {[number, number] | null} */
  point() {
    const { ends, image } = this.regions;
    if (!ends) return null;
    const place = placed(this.size, ends, this.plot(ends, image).here);
    return shares(this.size, place).every((share) => share >= 0 && share <= 1) ? place : null;
  }

  /**
   * The point at these shares of the two axes; its numbers have so many digits as the picture can tell.
   * @param {number[]} places
   */
  to(places) {
    const { ends } = this.regions;
    if (!ends || this.answers.waiting("charted")) return;             // no axes of another scene
    this.asked.axes.forEach((name, n) => {
      const [low, high] = ends[n], share = Math.min(1, Math.max(0, places[n]));
      this.set(name, written(rounded(ends[n], low + (high - low) * share)));
    });
  }

  /**
   * Other ends: what is at some shares of the two axes comes to others, and all is longer by a factor.
   * @param {number[]} from
   * @param {number[]} to
   * @param {number} factor
   */
  stretch(from, to, factor) {
    this.rescaled((scale, n) => stretched(scale, from[n], to[n], factor));
  }

  /** @param {(scale: Scale, n: number) => Scale} changed */
  rescaled(changed) {
    if (!this.regions.ends || this.answers.waiting("charted")) return;
    this.scales().forEach((scale, n) => this.asked.scales.set(scale.of.name, changed(scale, n)));
    this.settled();
  }
}
