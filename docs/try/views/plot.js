// A chart as it is drawn: by the context of a canvas, or by what stands for one.
import { readable, titled } from "./axes.js";

/** @typedef {import("./scales.js").Ends} Ends */
/** @typedef {[number, number]} Point */
/**
 * @typedef {object} Plot
 * @property {any} image the regions, the highest row first, as drawImage takes them
 * @property {{text: string, ends: Ends}[]} axes across and upwards
 * @property {Point[]} points of the boundary
 * @property {Point} here the point; its numbers are NaN where they are not known
 */
/** @typedef {{ink: string, quiet: string, paper: string}} Colours */

const LEFT = 46, TOP = 22, MARGINS = 60;                // both ways: the chart is a square in a square
const DIGIT = 7, GAP = 12, LINE = 30;                   // pixels: of a character, between texts, lines
const NUMBERS = "12px system-ui, sans-serif", NAMES = 'italic 15px "Times New Roman", Times, serif';

/** Where the regions are in a square picture. @param {number} size in pixels, as the rest */
export const frame = (size) => ({ left: LEFT, top: TOP, side: Math.max(size - MARGINS, 1) });

/**
 * Where a point is in the picture.
 * @param {number} size
 * @param {Ends[]} ends
 * @param {Point} point
 * @returns {Point}
 */
export function placed(size, [[first, last], [low, high]], [x, y]) {
  const { left, top, side } = frame(size);
  return [left + (x - first) / (last - first) * side, top + (high - y) / (high - low) * side];
}

/** Which shares of the two axes a place in the picture has. @param {number} size @param {Point} place */
export function shares(size, [x, y]) {
  const { left, top, side } = frame(size);
  return [(x - left) / side, 1 - (y - top) / side];
}

/**
 * Draws regions, boundary, axes and point.
 * @param {any} context
 * @param {number} size
 * @param {Plot} plot
 * @param {Colours} colours
 */
export function paint(context, size, { image, axes, points, here }, colours) {
  const { left, top, side } = frame(size), ends = axes.map((axis) => axis.ends);
  context.imageSmoothingEnabled = false;                // no pixel is a mixture of two proofs
  context.drawImage(image, left, top, side, side);
  context.fillStyle = colours.ink;
  for (const point of points) {
    const [x, y] = placed(size, ends, point);
    context.fillRect(x - 1, y - 1, 2, 2);
  }
  context.lineWidth = 1;
  context.strokeStyle = colours.quiet;
  const [first, last] = [-0.5, side + 0.5];
  const corners = [[first, first], [last, first], [last, last], [first, last]];
  lines(context, [...corners, corners[0]].map(([x, y]) => [left + x, top + y]));
  across(context, size, axes[0], colours);
  upwards(context, size, axes[1], colours);
  if (here.every(Number.isFinite)) mark(context, size, placed(size, ends, here), colours);
}

/** @param {any} context @param {Point[]} points */
function lines(context, [first, ...rest]) {
  context.beginPath();
  context.moveTo(...first);
  for (const point of rest) context.lineTo(...point);
  context.stroke();
}

/**
 * A text, at the left of its place, in its middle or at its right.
 * @param {any} context
 * @param {string} font
 * @param {string} align
 * @param {string} text
 * @param {number} x
 * @param {number} y
 */
function say(context, font, align, text, x, y) {
  context.font = font;
  context.textAlign = align;
  context.textBaseline = "alphabetic";
  context.fillText(text, x, y);
}

/**
 * @param {any} context
 * @param {number} size
 * @param {{text: string, ends: Ends}} axis
 * @param {Colours} colours
 */
function across(context, size, { text: name, ends }, { ink, quiet }) {
  const { left, top, side } = frame(size), bottom = top + side, [low, high] = ends;
  const { ticks, power } = readable(ends, side, (text) => DIGIT * text.length + GAP);
  for (const { value, text } of ticks) {
    const x = left + (value - low) / (high - low) * side;
    lines(context, [[x, bottom], [x, bottom + 4]]);
    context.fillStyle = quiet;
    say(context, NUMBERS, "center", text, Math.min(x, size - DIGIT * text.length / 2), bottom + 17);
  }
  context.fillStyle = ink;
  say(context, NAMES, "right", titled(name, power), left + side, bottom + 34);
}

/**
 * @param {any} context
 * @param {number} size
 * @param {{text: string, ends: Ends}} axis
 * @param {Colours} colours
 */
function upwards(context, size, { text: name, ends }, { ink, quiet }) {
  const { left, top, side } = frame(size), [low, high] = ends;
  const { ticks, power } = readable(ends, side, () => LINE);
  for (const { value, text } of ticks) {
    const y = top + (high - value) / (high - low) * side;
    lines(context, [[left - 4, y], [left, y]]);
    context.fillStyle = quiet;
    say(context, NUMBERS, "right", text, left - 7, y + 4);
  }
  context.fillStyle = ink;
  say(context, NAMES, "left", titled(name, power), left, top - 7);
}

/**
 * The point: a ring, which can be dragged; of one that is not on the chart an arrow at its edge.
 * @param {any} context
 * @param {number} size
 * @param {Point} place
 * @param {Colours} colours
 */
function mark(context, size, [x, y], { ink, paper }) {
  const { left, top, side } = frame(size);
  const inside = [Math.min(Math.max(x, left), left + side), Math.min(Math.max(y, top), top + side)];
  const away = Math.hypot(x - inside[0], y - inside[1]);
  for (const [colour, width] of [[paper, 5], [ink, 2]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    if (away > 1) arrow(context, inside, [(x - inside[0]) / away, (y - inside[1]) / away]);
    else ring(context, [x, y]);
    context.stroke();
  }
}

/** @param {any} context @param {Point} place */
function ring(context, [x, y]) {
  context.moveTo(x + 7, y);
  context.arc(x, y, 7, 0, 2 * Math.PI);
  for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    context.moveTo(x + 7 * dx, y + 7 * dy);
    context.lineTo(x + 12 * dx, y + 12 * dy);
  }
}

/** @param {any} context @param {number[]} tip @param {number[]} towards of length 1 */
function arrow(context, [x, y], [dx, dy]) {
  context.moveTo(x - 10 * dx + 6 * dy, y - 10 * dy - 6 * dx);
  context.lineTo(x - 2 * dx, y - 2 * dy);
  context.lineTo(x - 10 * dx - 6 * dy, y - 10 * dy + 6 * dx);
}
