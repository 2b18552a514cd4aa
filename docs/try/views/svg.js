// A picture as SVG: it is drawn by the methods of a canvas's 2D context, and works outside a browser too.

/** What save() keeps: of a drawing as of a canvas. */
const KEPT = ["fillStyle", "strokeStyle", "lineWidth", "lineCap", "lineJoin", "globalAlpha", "font", "textAlign",
  "textBaseline", "dash", "scaled", "left", "top", "inside"];
/** Where a text stands below the place that is given for it, in heights of its letters. */
const BELOW = { alphabetic: 0, middle: 0.35, top: 0.8, hanging: 0.8, bottom: -0.2 };
const ANCHORS = { left: "start", start: "start", center: "middle", right: "end", end: "end" };
const FONT = /^(?:(italic) )?(?:(normal|bold|\d+) )?([\d.]+)px (.+)$/;
// What no XML may have: control characters and halves of a pair of surrogates.
const FORBIDDEN = /[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]|\p{Cs}/gu;
const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

const round = (x) => String(Number(x.toFixed(2)) + 0);

/**
 * A text as a part of XML.
 * @param {string} text
 * @returns {string}
 */
export const escaped = (text) => String(text).replace(FORBIDDEN, "\ufffd").replace(/[&<>"]/g, (sign) => ENTITIES[sign]);

/** The methods of a 2D context that the page's pictures need; String() of it is the picture. */
export class Svg {
  /**
   * @param {number} width
   * @param {number} height
   * @param {string} title what the picture is, for those who do not see it
   * @param {(image: any) => string} [encoded] a data URL of what drawImage is given
   */
  constructor(width, height, title, encoded = (image) => image.toDataURL("image/png")) {
    Object.assign(this, { width, height, title, encoded });
    /** @type {string[]} */ this.parts = [];
    /** @type {string[]} */ this.steps = [];
    /** @type {Record<string, any>[]} */ this.saved = [];
    this.fillStyle = this.strokeStyle = "#000000";
    this.lineWidth = this.globalAlpha = this.scaled = 1;
    this.left = this.top = this.clips = 0;
    this.lineCap = "butt";
    this.lineJoin = "miter";
    this.font = "10px sans-serif";
    this.textAlign = "start";
    this.textBaseline = "alphabetic";
    this.inside = "";
    /** @type {number[]} */ this.dash = [];
  }

  save() {
    this.saved.push(Object.fromEntries(KEPT.map((name) => [name, this[name]])));
  }

  restore() {
    Object.assign(this, this.saved.pop());
  }

  translate(x, y) {
    this.left += this.scaled * x;
    this.top += this.scaled * y;
  }

  /** @param {number} factor of both directions: a picture is made larger, never longer */
  scale(factor) {
    this.scaled *= factor;
  }

  setLineDash(dash) {
    this.dash = [...dash];
  }

  /** A place as it is written. */
  place(x, y) {
    return `${round(this.left + this.scaled * x)} ${round(this.top + this.scaled * y)}`;
  }

  beginPath() {
    this.steps = [];
  }

  moveTo(x, y) {
    this.steps.push(`M${this.place(x, y)}`);
  }

  lineTo(x, y) {
    this.steps.push(`${this.steps.length ? "L" : "M"}${this.place(x, y)}`);
  }

  closePath() {
    this.steps.push("Z");
  }

  rect(x, y, width, height) {
    this.moveTo(x, y);
    this.lineTo(x + width, y);
    this.lineTo(x + width, y + height);
    this.lineTo(x, y + height);
    this.closePath();
  }

  arc(x, y, radius, from, to, back = false) {
    this.ellipse(x, y, radius, radius, 0, from, to, back);
  }

  /** SVG has no arc from a point to itself: a long one is drawn in two. */
  ellipse(x, y, a, b, turned, from, to, back = false) {
    const whole = 2 * Math.PI, wide = back ? from - to : to - from;
    const angle = wide >= whole ? whole : (wide % whole + whole) % whole;
    const ends = [0, angle / 2, angle].map((part) => from + (back ? -part : part));
    const [start, ...rest] = ends.map((t) => this.place(
      x + a * Math.cos(t) * Math.cos(turned) - b * Math.sin(t) * Math.sin(turned),
      y + a * Math.cos(t) * Math.sin(turned) + b * Math.sin(t) * Math.cos(turned)));
    const radii = `${round(a * this.scaled)} ${round(b * this.scaled)} ${round(turned * 180 / Math.PI)}`;
    this.steps.push(`${this.steps.length ? "L" : "M"}${start}`, ...rest.map((end) => `A${radii} 0 ${back ? 0 : 1} ${end}`));
  }

  /** An element, in what is clipped. */
  add(name, attributes, content) {
    const opacity = this.globalAlpha < 1 ? { opacity: round(this.globalAlpha) } : {};
    const all = Object.entries({ ...attributes, ...opacity, ...this.inside && { "clip-path": `url(#${this.inside})` } });
    const head = `<${name} ${all.map(([key, value]) => `${key}="${escaped(value)}"`).join(" ")}`;
    this.parts.push(content === undefined ? `${head}/>` : `${head}>${escaped(content)}</${name}>`);
  }

  stroke() {
    const dash = this.dash.length ? { "stroke-dasharray": this.dash.map((x) => round(x * this.scaled)).join(" ") } : {};
    if (this.steps.length) this.add("path", { d: this.steps.join(""), fill: "none", stroke: this.strokeStyle,
      "stroke-width": round(this.lineWidth * this.scaled), "stroke-linecap": this.lineCap,
      "stroke-linejoin": this.lineJoin, ...dash });
  }

  fill(rule = "nonzero") {
    if (this.steps.length) this.add("path", { d: this.steps.join(""), fill: this.fillStyle, "fill-rule": rule });
  }

  /** What follows is drawn inside this path, until restore(). */
  clip() {
    this.inside = `inside${++this.clips}`;
    this.parts.push(`<clipPath id="${this.inside}"><path d="${this.steps.join("")}"/></clipPath>`);
  }

  /** Around a rectangle, or in it: the path that is being drawn stays. */
  rectangle(x, y, width, height, draw) {
    const { steps } = this;
    this.steps = [];
    this.rect(x, y, width, height);
    draw();
    this.steps = steps;
  }

  fillRect(x, y, width, height) {
    this.rectangle(x, y, width, height, () => this.fill());
  }

  strokeRect(x, y, width, height) {
    this.rectangle(x, y, width, height, () => this.stroke());
  }

  /** There is nothing below a picture that could be seen again. */
  clearRect() {}

  fillText(text, x, y) {
    const [, style = "normal", weight = "normal", size, family] = FONT.exec(this.font) ?? [, , , 10, "sans-serif"];
    const letters = Number(size) * this.scaled;
    this.add("text", { x: round(this.left + this.scaled * x),
      y: round(this.top + this.scaled * y + BELOW[this.textBaseline] * letters), fill: this.fillStyle,
      "text-anchor": ANCHORS[this.textAlign], "font-size": round(letters), "font-weight": weight, "font-style": style,
      "font-family": family }, text);
  }

  drawImage(image, x, y, width = image.width, height = image.height) {
    this.add("image", { x: round(this.left + this.scaled * x), y: round(this.top + this.scaled * y),
      width: round(width * this.scaled), height: round(height * this.scaled), preserveAspectRatio: "none",
      style: "image-rendering:pixelated", href: this.encoded(image) });
  }

  toString() {
    const { width, height } = this, title = escaped(this.title);
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" `
      + `role="img" aria-label="${title}"><title>${title}</title>\n${this.parts.join("\n")}\n</svg>\n`;
  }
}
