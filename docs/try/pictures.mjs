// A small picture of an example, from its prepared answers: its chart, or a dot for each equilibrium in the colour of
// its verdict.
import { crc32, deflateSync } from "node:zlib";
import { number } from "./app/numbers.js";
import { Regions } from "./numerics/regions.js";
import { fitted } from "./views/scales.js";

const SIZE = 64;                                        // pixels
// in the order of the codes of regions.js; readable on white and on black
const INKS = ["#808080", "#3fae8f", "#e08a52", "#8398d8", "#a0a0a0"];
const DOTS = { STABLE: INKS[1], UNSTABLE: INKS[2], UNDECIDED: INKS[3] };

/** @param {string} ink */
const colour = (ink) => [1, 3, 5].map((at) => parseInt(ink.slice(at, at + 2), 16));

/** @param {string} kind @param {Buffer} data */
function chunk(kind, data) {
  const body = Buffer.concat([Buffer.from(kind, "latin1"), data]), length = Buffer.alloc(4), check = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  check.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, check]);
}

/**
 * A PNG of colours from a palette, the lowest row first.
 * @param {Uint8Array} codes
 * @param {number} size
 */
export function png(codes, size) {
  const head = Buffer.alloc(13), rows = [];
  head.writeUInt32BE(size, 0);
  head.writeUInt32BE(size, 4);
  head.set([8, 3, 0, 0, 0], 8);                         // 8 bits, a palette
  for (let y = size - 1; y >= 0; y--) rows.push(Buffer.from([0]), Buffer.from(codes.subarray(y * size, (y + 1) * size)));
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", head),
    chunk("PLTE", Buffer.from(INKS.flatMap(colour))), chunk("IDAT", deflateSync(Buffer.concat(rows), { level: 9 })),
    chunk("IEND", Buffer.alloc(0))]);
}

/**
 * The chart as the page shows it first.
 * @param {any} chart
 * @param {string[]} axes
 * @param {Record<string, string>} values
 * @param {import("./views/scales.js").Name[]} names
 */
function charted(chart, axes, values, names) {
  const numbers = Object.fromEntries(Object.entries(values).map(([name, text]) => [name, number(name, text)]));
  const regions = new Regions(chart, axes, SIZE), scales = fitted(new Map(), names, (name) => numbers[name]);
  return png(regions.drawn(numbers, /** @type {any} */ (axes.map((name) => scales.get(name)?.ends))), SIZE);
}

/** @param {(keyof typeof DOTS)[]} verdicts */
function dotted(verdicts) {
  const across = Math.ceil(Math.sqrt(verdicts.length)), step = SIZE / across;
  const dots = verdicts.map((verdict, n) => `<circle cx="${(n % across + 0.5) * step}" cy="${(Math.floor(n / across) + 0.5) * step}" `
    + `r="${step * 0.3}" fill="${DOTS[verdict] ?? INKS[0]}"/>`);
  return Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE} ${SIZE}">${dots.join("")}</svg>`);
}

/**
 * The picture, and how its name ends.
 * @param {import("./app/prepared.js").Prepared} found
 * @returns {["png" | "svg", Buffer]}
 */
export function pictured({ analysed, charted: chart, decided: { question, answer } }) {
  if (chart?.answer.steps) return ["png", charted(chart.answer, chart.question.axes, question.values, analysed.answer.names)];
  return ["svg", dotted((answer.found ?? [answer]).map((/** @type {any} */ { verdict }) => verdict))];
}
