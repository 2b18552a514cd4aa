// A chart of two names: in each pixel what doubles prove of the criteria, over it the zeros of the margins, exact.
import { Card } from "../app/card.js";
import { notice, reload } from "../app/notices.js";
import { element } from "./blocks.js";

const SIZE = 400, STEPS = 100, SOON = 60;               // pixels; keys from end to end; milliseconds
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
// the swatches of the key, in the order of their codes in regions.js
const COLOURS = ["unknown", "stable", "unstable", "open", "nowhere"];

export class Chart {
  // place: the section; ask(want, scene, more): of the library; set(name, text): a number of the page;
  // settled(): called when something has come
  constructor(place, ask, set, settled) {
    Object.assign(this, { place, set, settled, axes: ["", ""], wanted: [] });
    const find = (name) => place.querySelector(name);
    [this.canvas, this.across, this.upwards, this.why, this.drawn] = ["canvas", "#across", "#upwards", "#no-chart",
      ".drawn"].map(find);
    this.picture = element("canvas", { width: SIZE, height: SIZE });
    this.programs = new Card(({ scene, more }) => ask("charted", scene, more), (found) => this.load(found), settled);
    this.edges = new Card(({ scene, more }) => ask("edges", scene, more), () => {}, settled);
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
    return this.programs.waiting || this.asked !== null && this.asked !== this.answered;
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
    this.axes = [this.across.value, this.upwards.value];
  }

  // Another axis; the name of the other one changes places with it.
  turned(n) {
    const selects = [this.across, this.upwards];
    if (selects[n].value === this.axes[1 - n]) selects[1 - n].value = this.axes[n];
    this.axes = selects.map((select) => select.value);
    this.settled();
  }

  // What the page asks now: its scene, null if it is refused, undefined while it is not known; its numbers by their
  // names, as they are typed, and number(name), NaN of one that is none; whether the library is still reading them.
  follow(scene, values, number, reading) {
    const { axes } = this;
    this.values = number;
    this.programs.follow(scene && { scene, more: [axes] });
    if (this.programs.waiting) return;
    const others = Object.entries(values).filter(([name]) => !axes.includes(name));
    const needed = (this.program?.names ?? []).filter((name) => !axes.includes(name)).map((name) => [name, number(name)]);
    const unread = needed.some(([, value]) => !Number.isFinite(value));
    const refused = this.refused(unread && !reading);
    this.why.textContent = refused;
    this.drawn.hidden = Boolean(refused);
    this.paint(refused ? null : unread ? undefined : { chart: this.programs.asked, ends: this.ends(),
      numbers: Object.fromEntries(needed), colours: this.colours });
    this.edges.follow(refused ? null : this.waiting ? undefined : { more: [axes, this.ends()],
      scene: { ...scene, values: Object.fromEntries(others) } }, SOON);
    this.draw();
  }

  // Why there is no picture; "" if there is one.
  refused(unread) {
    if (!this.programs.answer) return "no chart: the scene has no answer";
    return this.broken ?? this.programs.answer.why ?? this.programs.answer.error
      ?? (unread ? "a picture needs numbers, and possible ones" : this.colours ? "" : "no chart without its colours");
  }

  // A program, or none.
  load(found) {
    this.program = this.shown = this.answered = this.last = null;
    if (!found?.steps) return;
    this.program = found;
    this.worker.postMessage({ chart: found, axes: this.axes, width: SIZE });
  }

  // What the picture is asked for; those of numbers before are shown on the way to it.
  paint(question) {
    const asked = question && JSON.stringify(question);
    if (asked === this.asked) return;
    this.asked = asked;
    if (asked) this.worker.postMessage({ ...question, ends: question.ends.map((pair) => pair.map(Number)), asked });
  }

  come({ pixels, ends, chart, asked }) {
    if (chart !== this.programs.asked) return;          // of another chart
    this.shown = ends;
    this.answered = asked;
    this.picture.getContext("2d").putImageData(new ImageData(pixels, SIZE), 0, 0);
    this.settled();
  }

  // The ends of an axis, as they are written.
  ends() {
    return this.axes.map((name) => {
      const { min, max } = document.getElementById(`value-${name}`).closest(".value").querySelector("[type=range]");
      return [min, max];
    });
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
    const here = this.axes.map(this.values), drawn = JSON.stringify([this.answered, this.edges.waiting, here]);
    if (!this.shown || drawn === this.last) return;
    this.last = drawn;
    const context = this.canvas.getContext("2d"), [[left, right], [low, high]] = this.shown;
    const place = ([x, y]) => [(x - left) / (right - left) * SIZE, SIZE - (y - low) / (high - low) * SIZE];
    context.drawImage(this.picture, 0, 0);
    context.fillStyle = context.strokeStyle = this.ink;
    const found = this.edges.waiting ? null : this.edges.answer;
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
    const [across, upwards] = this.axes;
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
    const share = this.axes.map((name, n) => {
      const [from, to] = this.shown[n];
      return (this.values(name) - from) / (to - from) + step[n] / STEPS;
    });
    this.to(...share);
  }

  // The point at these shares of the two axes; its numbers have so many digits as the picture can tell.
  to(...shares) {
    if (!this.shown || this.programs.waiting) return;   // no axes of another scene
    this.axes.forEach((name, n) => {
      const [from, to] = this.shown[n], share = Math.min(1, Math.max(0, shares[n]));
      this.set(name, String(Number((from + (to - from) * share).toFixed(3))));
    });
  }
}
