// A chart of two names: in each pixel what doubles prove of the criteria, over it the zeros of the margins, exact.

const SIZE = 400, STEPS = 100;
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
// the swatches of the key, in the order of their codes in regions.js
const COLOURS = ["unknown", "stable", "unstable", "open", "nowhere"];

export class Chart {
  // place: the section; ask(want, more): of the library; set(name, text): a number of the page
  constructor(place, ask, set) {
    Object.assign(this, { place, ask, set, loads: 0, axes: ["", ""], wanted: [], decided: [{}, ""] });
    const find = (name) => place.querySelector(name);
    [this.canvas, this.across, this.upwards, this.why] = ["canvas", "#across", "#upwards", "#no-chart"].map(find);
    this.picture = new OffscreenCanvas(SIZE, SIZE);
    this.worker = new Worker("chart-worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => this.come(data);
    this.across.onchange = () => this.turned(0);
    this.upwards.onchange = () => this.turned(1);
    this.canvas.onpointerdown = (event) => this.pointed(event);
    this.canvas.onkeydown = (event) => this.moved(event);
    this.inks();
    matchMedia("(prefers-color-scheme: dark)").onchange = () => {
      this.inks();
      this.follow();
    };
  }

  // The names are those of another equilibrium, until it is chosen.
  leave() {
    this.ready = false;
  }

  // Another equilibrium: its names, the first two chosen where the old ones are none of them.
  async choose(names, values) {
    this.values = values;
    for (const [n, select] of [this.across, this.upwards].entries()) {
      const old = this.wanted[n] ?? select.value;
      select.replaceChildren(...names.map((name) => new Option(name, name)));
      select.value = names.includes(old) ? old : names.at(n - 2) ?? "";
    }
    this.wanted = [];
    await this.load();
  }

  // Another axis; the name of the other one changes places with it.
  turned(n) {
    const selects = [this.across, this.upwards];
    if (selects[n].value === this.axes[1 - n]) selects[1 - n].value = this.axes[n];
    this.load();
  }

  async load() {
    this.leave();
    this.axes = [this.across.value, this.upwards.value];
    const chart = await this.ask("charted", [this.axes]);
    if (!chart) return;
    this.why.textContent = chart.why ?? chart.error ?? "";
    this.place.classList.toggle("none", Boolean(this.why.textContent));
    if (this.why.textContent) return;
    this.names = chart.names;
    this.loads += 1;
    this.worker.postMessage({ chart, axes: this.axes, width: SIZE });
    this.ready = true;
    this.follow();
  }

  // The ends of an axis, as they are written.
  ends() {
    return this.axes.map((name) => {
      const { min, max } = document.getElementById(`value-${name}`).closest(".value").querySelector("[type=range]");
      return [min, max];
    });
  }

  // What the library decides, where the cross is.
  say(values, word) {
    this.decided = [values, word];
    if (!this.shown) return;
    this.place.querySelector("#here").textContent = `${this.axes.map((n) => `${n} = ${values[n]}`).join(", ")}: ${word}`;
  }

  // Numbers have changed.
  follow() {
    if (!this.ready) return;
    this.drawnEdges = [];
    const numbers = Object.fromEntries(this.names.map((name) => [name, this.values(name)]));
    if (this.names.some((name) => !this.axes.includes(name) && !Number.isFinite(numbers[name]))) {
      this.why.textContent = "a picture needs numbers";
      return;
    }
    this.why.textContent = "";
    this.worker.postMessage({ numbers, load: this.loads, ends: this.ends().map((pair) => pair.map(Number)),
      colours: this.colours });
    clearTimeout(this.late);
    this.late = setTimeout(() => this.bound(), 60);
  }

  async bound() {
    const found = await this.ask("edges", [this.axes, this.ends()]);
    this.drawnEdges = found?.points ?? [];
    this.draw();
  }

  come({ pixels, ends, load }) {
    if (load !== this.loads) return;                    // of another chart
    this.shown = ends;
    this.say(...this.decided);
    this.picture.getContext("2d").putImageData(new ImageData(pixels, SIZE), 0, 0);
    this.draw();
  }

  // Red, green, blue and 255 of each swatch; the colour of what is drawn over the picture.
  inks() {
    this.colours = COLOURS.map((name) => {
      const style = getComputedStyle(this.place.querySelector(`.key .${name}`));
      return [...style.backgroundColor.match(/\d+/g).slice(0, 3).map(Number), 255];
    });
    this.ink = getComputedStyle(this.canvas).color;
  }

  draw() {
    if (!this.shown) return;
    const context = this.canvas.getContext("2d"), [[left, right], [low, high]] = this.shown;
    const place = ([x, y]) => [(x - left) / (right - left) * SIZE, SIZE - (y - low) / (high - low) * SIZE];
    context.drawImage(this.picture, 0, 0);
    context.fillStyle = context.strokeStyle = this.ink;
    for (const point of this.drawnEdges) {
      const [x, y] = place(point);
      context.fillRect(x - 1, y - 1, 2, 2);
    }
    const here = this.axes.map(this.values), [x, y] = place(here);
    context.lineWidth = 2;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + 3 * dx, y + 3 * dy);
      context.lineTo(x + 11 * dx, y + 11 * dy);
    }
    context.stroke();
    const [across, upwards] = this.axes;
    this.place.querySelector("#ends").textContent =
      `${across} from ${left} to ${right} across, ${upwards} from ${low} to ${high} upwards`;
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
    if (!this.shown) return;
    this.axes.forEach((name, n) => {
      const [from, to] = this.shown[n], share = Math.min(1, Math.max(0, shares[n]));
      this.set(name, String(Number((from + (to - from) * share).toFixed(3))));
    });
  }
}
