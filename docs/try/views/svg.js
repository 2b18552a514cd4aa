// A picture as SVG: it is drawn by methods of a canvas's 2D context, and outside a browser too.

/** How far below its place the line of a text is, of its letters' height. @type {Record<string, number>} */
const BELOW = { alphabetic: 0, middle: 0.35 };
/** @type {Record<string, string>} */
const ANCHORS = { left: "start", center: "middle", right: "end" };
const FONT = /^(?:(italic) )?(?:(normal|bold|\d+) )?([\d.]+)px (.+)$/;
// What no XML may have: control characters and halves of a pair of surrogates.
const FORBIDDEN = /(?![\t\n\r])[\p{Cc}\p{Cs}\ufffe\uffff]/gu;

/** @param {number} x */
const round = (x) => String(Number(x.toFixed(2)) + 0);

/** A text as a part of XML. @param {any} text */
export const escaped = (text) => String(text).replace(FORBIDDEN, "\ufffd")
  .replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** The methods of a 2D context that the page's pictures need; String() of it is the picture. */
export class Svg {
  /**
   * @param {number} width
   * @param {number} height
   * @param {string} title what the picture is, for those who do not see it
   * @param {(image: any) => string} [encoded] a data URL of what drawImage is given
   */
  constructor(width, height, title, encoded = (image) => image.toDataURL("image/png")) {
    this.width = width;
    this.height = height;
    this.title = title;
    this.encoded = encoded;
    /** @type {string[]} */
    this.parts = [];
    /** @type {string[]} */
    this.steps = [];
    this.fillStyle = this.strokeStyle = "#000000";
    this.lineWidth = this.globalAlpha = this.scaled = 1;
    this.left = this.top = 0;
    this.font = "10px sans-serif";
    this.textAlign = "left";
    this.textBaseline = "alphabetic";
    /** @type {number[]} */
    this.dash = [];
  }

  /** @param {number} x @param {number} y */
  translate(x, y) {
    this.left += this.scaled * x;
    this.top += this.scaled * y;
  }

  /** @param {number} factor of both directions: a picture is made larger, never longer */
  scale(factor) {
    this.scaled *= factor;
  }

  /** @param {number[]} dash */
  setLineDash(dash) {
    this.dash = [...dash];
  }

  /** A place as it is written. @param {number} x @param {number} y */
  place(x, y) {
    return `${round(this.left + this.scaled * x)} ${round(this.top + this.scaled * y)}`;
  }

  beginPath() {
    this.steps = [];
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.steps.push(`M${this.place(x, y)}`);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    this.steps.push(`${this.steps.length ? "L" : "M"}${this.place(x, y)}`);
  }

  closePath() {
    this.steps.push("Z");
  }

  /** A circle, from its point at an angle and back there; SVG has no arc from a point to itself, so in two.
   * @param {number} x @param {number} y @param {number} radius @param {number} from */
  arc(x, y, radius, from) {
    const a = radius * Math.cos(from), b = radius * Math.sin(from), length = round(radius * this.scaled);
    this.lineTo(x + a, y + b);
    for (const way of [-1, 1]) {
      this.steps.push(`A${length} ${length} 0 0 1 ${this.place(x + way * a, y + way * b)}`);
    }
  }

  /** @param {string} name @param {Record<string, string>} attributes @param {string} [content] */
  add(name, attributes, content) {
    const opacity = this.globalAlpha < 1 && { opacity: round(this.globalAlpha) };
    const all = Object.entries({ ...attributes, ...opacity });
    const head = `<${name}${all.map(([key, value]) => ` ${key}="${escaped(value)}"`).join("")}`;
    this.parts.push(content === undefined ? `${head}/>` : `${head}>${escaped(content)}</${name}>`);
  }

  stroke() {
    const dashes = this.dash.map((x) => round(x * this.scaled)).join(" ");
    if (this.steps.length) this.add("path", { d: this.steps.join(""), fill: "none", stroke: this.strokeStyle,
      "stroke-width": round(this.lineWidth * this.scaled), ...dashes && { "stroke-dasharray": dashes } });
  }

  fill() {
    if (this.steps.length) this.add("path", { d: this.steps.join(""), fill: this.fillStyle });
  }

  /** Where a box is. @param {number} x @param {number} y @param {number} width @param {number} height */
  box(x, y, width, height) {
    const { left, top, scaled } = this;
    return { x: round(left + scaled * x), y: round(top + scaled * y), width: round(scaled * width),
      height: round(scaled * height) };
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  fillRect(x, y, width, height) {
    this.add("rect", { ...this.box(x, y, width, height), fill: this.fillStyle });
  }

  /** @param {string} text @param {number} x @param {number} y */
  fillText(text, x, y) {
    const [, style, weight, size, family] = FONT.exec(this.font) ?? [], letters = Number(size) * this.scaled;
    this.add("text", { x: round(this.left + this.scaled * x),
      y: round(this.top + this.scaled * y + BELOW[this.textBaseline] * letters), fill: this.fillStyle,
      "text-anchor": ANCHORS[this.textAlign], "font-size": round(letters), "font-family": family,
      ...weight && { "font-weight": weight }, ...style && { "font-style": style } }, text);
  }

  /** @param {any} image @param {number} x @param {number} y @param {number} width @param {number} height */
  drawImage(image, x, y, width, height) {
    this.add("image", { ...this.box(x, y, width, height), preserveAspectRatio: "none",
      style: "image-rendering:pixelated", href: this.encoded(image) });
  }

  toString() {
    const { width, height } = this, title = escaped(this.title);
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" role="img" `
      + `width="${width}" height="${height}" `
      + `aria-label="${title}"><title>${title}</title>\n${this.parts.join("\n")}\n</svg>\n`;
  }
}
