// A chart of two names: in each pixel what doubles prove of the criteria, over it the zeros of the margins, exact.
import { notice, reload } from "../app/notices.js";
import { possible } from "../app/numbers.js";
import { element } from "./blocks.js";

const SIZE = 400, STEPS = 100;                          // pixels; keys from end to end
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
// the swatches of the key, in the order of their codes in regions.js
const COLOURS = ["unknown", "stable", "unstable", "open", "nowhere"];

export class Chart {
  /**
   * @param {Element} place the section
   * @param {import("../app/scene.js").Asked} asked
   * @param {import("../app/answers.js").Answers} answers
   * @param {(name: string, text: string) => void} set sets a number of the page
   * @param {() => void} settled called when something has come or another axis is chosen
   */
  constructor(place, asked, answers, set, settled) {
    Object.assign(this, { place, asked, answers, set, settled, wanted: [] });
    const find = (name) => place.querySelector(name);
    [this.canvas, this.across, this.upwards, this.why, this.drawn] = ["canvas", "#across", "#upwards", "#no-chart",
      ".drawn"].map(find);
    this.picture = element("canvas", { width: SIZE, height: SIZE });
    this.worker = new Worker("numerics/chart-worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => this.come(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.broken = "no chart, see the top of this page";
      notice("chart", `The chart failed (${event.message || "a file of it did not come"}).`, ...reload);
      settled();
    };
    this.across.onchange = () => this.turned(0);
    this.upwards.onchange = () => this.turned(1);
    this.canvas.onpointerdown = (event) => this.pointed(event);
    this.canvas.onkeydown = (event) => this.moved(event);
    this.inks();
    matchMedia("(prefers-color-scheme: dark)").onchange = () => {
      this.inks();
      settled();
    };
  }

  // Whether what is drawn is of another scene than the page's, or of other numbers.
  get waiting() {
    return this.answers.waiting("charted") || this.painting !== null && this.painting !== this.painted;
  }

  // Another equilibrium: of its names two that differ, the old ones or those of a link if they are among them.
  choose(names) {
    let [x, y] = [this.across, this.upwards].map((select, n) => this.wanted[n] ?? select.value)
      .map((name) => names.includes(name) ? name : undefined);
    if (x === y) y = undefined;
    const [last, before] = names.toReversed();
    x ??= before === y ? last : before ?? last;
    y ??= last === x ? before : last;
    for (const [select, name] of [[this.across, x], [this.upwards, y]]) {
      select.replaceChildren(...names.map((name) => new Option(name, name)));
      select.value = name ?? "";
    }
    this.wanted = [];
    this.asked.axes = [this.across.value, this.upwards.value];
  }

  // Another axis; the name of the other one changes places with it.
  turned(n) {
    const selects = [this.across, this.upwards];
    if (selects[n].value === this.asked.axes[1 - n]) selects[1 - n].value = this.asked.axes[n];
    this.asked.axes = selects.map((select) => select.value);
    this.settled();
  }

  // Drawn from what is asked and answered; reading: whether the library is still reading the numbers.
  follow(reading) {
    const { asked: { axes }, answers } = this, { answer, asked } = answers.answered.charted ?? {};
    if (answers.waiting("charted")) return;
    if (asked !== this.loaded) this.load(answer, asked);
    const needed = (this.program?.names ?? []).filter((name) => !axes.includes(name)).map((name) => [name, this.value(name)]);
    const unread = needed.some(([, value]) => !Number.isFinite(value));
    const refused = this.refused(answer, unread && !reading);
    this.why.textContent = refused;
    this.drawn.hidden = Boolean(refused);
    this.paint(refused ? null : unread ? undefined : { chart: this.loaded, ends: this.ends(),
      numbers: Object.fromEntries(needed), colours: this.colours });
    this.draw();
  }

  // A number of the page as a double, NaN of one that is none.
  value(name) {
    return possible(name, this.asked.values[name]);
  }

  // From where to where an axis goes, as it is written.
  ends() {
    return this.asked.axes.map((name) => this.asked.ends[name]);
  }

  // Why there is no picture; "" if there is one.
  refused(answer, unread) {
    if (!answer) return "no chart: the scene has no answer";
    return this.broken ?? answer.why ?? answer.error
      ?? (unread ? "a picture needs numbers, and possible ones" : this.colours ? "" : "no chart without its colours");
  }

  // A program, or none.
  load(found, asked) {
    this.program = this.shown = this.painted = this.last = null;
    this.loaded = asked;
    if (!found?.steps) return;
    this.program = found;
    this.worker.postMessage({ chart: found, axes: this.asked.axes, width: SIZE });
  }

  // What the picture is asked for; those of numbers before are shown on the way to it.
  paint(question) {
    const asked = question && JSON.stringify(question);
    if (asked === this.painting) return;
    this.painting = asked;
    if (asked) this.worker.postMessage({ ...question, ends: question.ends.map((pair) => pair.map(Number)), asked });
  }

  come({ pixels, ends, chart, asked }) {
    if (chart !== this.loaded) return;                  // of another chart
    this.shown = ends;
    this.painted = asked;
    this.picture.getContext("2d").putImageData(new ImageData(pixels, SIZE), 0, 0);
    this.settled();
  }

  // Red, green, blue and 255 of each swatch, null if they are not all different; the colour of what is drawn over
  // the picture.
  inks() {
    const colours = COLOURS.map((name) => {
      const style = getComputedStyle(this.place.querySelector(`.key .${name}`));
      return [...style.backgroundColor.match(/\d+/g).slice(0, 3).map(Number), 255];
    });
    this.colours = new Set(colours.map(String)).size === COLOURS.length ? colours : null;
    this.ink = getComputedStyle(this.canvas).color;
  }

  draw() {
    const { asked: { axes }, answers } = this, here = axes.map((name) => this.value(name));
    const drawn = JSON.stringify([this.painted, answers.waiting("edges"), here]);
    if (!this.shown || drawn === this.last) return;
    this.last = drawn;
    const context = this.canvas.getContext("2d"), [[left, right], [low, high]] = this.shown;
    const place = ([x, y]) => [(x - left) / (right - left) * SIZE, SIZE - (y - low) / (high - low) * SIZE];
    context.drawImage(this.picture, 0, 0);
    context.fillStyle = context.strokeStyle = this.ink;
    const found = answers.of("edges");
    for (const point of found?.points ?? []) {
      const [x, y] = place(point);
      context.fillRect(x - 1, y - 1, 2, 2);
    }
    const [x, y] = place(here);
    context.lineWidth = 2;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + 3 * dx, y + 3 * dy);
      context.lineTo(x + 11 * dx, y + 11 * dy);
    }
    context.stroke();
    const [across, upwards] = axes;
    this.place.querySelector("#ends").textContent = `${across} from ${left} to ${right} across, ${upwards} from ${low} to `
      + `${high} upwards${found?.error ? `; no boundary is drawn: ${found.error}` : ""}`;
    this.canvas.ariaLabel = `Chart of the verdict, ${across} across and ${upwards} upwards. The cross is at ${across} = `
      + `${here[0]}, ${upwards} = ${here[1]}. Arrow keys move it.`;
  }

  pointed({ offsetX, offsetY }) {
    const { clientWidth, clientHeight } = this.canvas;
    this.to(offsetX / clientWidth, 1 - offsetY / clientHeight);
  }

  moved(event) {
    const step = KEYS[event.key];
    if (!step || !this.shown) return;
    event.preventDefault();
    const share = this.asked.axes.map((name, n) => {
      const [from, to] = this.shown[n];
      return (this.value(name) - from) / (to - from) + step[n] / STEPS;
    });
    this.to(...share);
  }

  // The point at these shares of the two axes; its numbers have so many digits as the picture can tell.
  to(...shares) {
    if (!this.shown || this.answers.waiting("charted")) return;   // no axes of another scene
    this.asked.axes.forEach((name, n) => {
      const [from, to] = this.shown[n], share = Math.min(1, Math.max(0, shares[n]));
      this.set(name, String(Number((from + (to - from) * share).toFixed(3))));
    });
  }
}
