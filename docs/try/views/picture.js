// A picture of what the page shows, for paper: the scene, its verdict, body, chart with its key, numbers.
import { Svg } from "./svg.js";

/** @typedef {{ width: number, height: number, draw: (context: any) => void }} View */
/**
 * @typedef {object} Seen
 * @property {string} title the name of the scene; "" if it has none
 * @property {string} line the scene in one line
 * @property {{ text: string, colour: string, more: string }} verdict more: what stands below it, or ""
 * @property {View[]} views beside each other
 * @property {{ text: string, colour: string }[]} key what the colours of the chart mean
 * @property {string[]} numbers each with its name
 * @property {{ ink: string, quiet: string, line: string, paper: string }} inks
 */

const WIDE = 880, MARGIN = 24, GAP = 16;
const FAMILY = "system-ui, sans-serif", LETTER = 0.53;   // the width of a letter, of its height

/** A text in lines of so many letters, broken at its spaces. @param {string} text @param {number} most */
function broken(text, most) {
  const lines = [""], part = new RegExp(`.{1,${most}}`, "gu");
  const words = text.split(/ +/).flatMap((word) => word.match(part) ?? []);
  for (const word of words) {
    const longer = `${lines.at(-1)} ${word}`.trim();
    if (longer.length <= most) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines.filter(Boolean);
}

/** Its height, and what draws it. @param {Seen} seen */
export function composed(seen) {
  /** @type {((context: any) => void)[]} */
  const steps = [];
  let top = MARGIN;
  /** @param {string} text @param {number} size @param {string} colour */
  const say = (text, size, colour, weight = "400") => {
    for (const line of broken(text, Math.floor((WIDE - 2 * MARGIN) / (LETTER * size)))) {
      const base = top + size;
      top += Math.round(1.35 * size);
      steps.push((context) => {
        context.font = `${weight} ${size}px ${FAMILY}`;
        context.textAlign = "left";
        context.textBaseline = "alphabetic";
        context.fillStyle = colour;
        context.fillText(line, MARGIN, base);
      });
    }
  };
  say(seen.title, 20, seen.inks.ink, "600");
  say(seen.line, 15, seen.inks.quiet);
  top += 4;
  say(seen.verdict.text, 30, seen.verdict.colour, "700");
  say(seen.verdict.more, 15, seen.inks.quiet);
  top += 8;
  const wide = (WIDE - 2 * MARGIN - GAP) / 2, begun = top;
  seen.views.forEach(({ width, height, draw }, n) => {
    const factor = wide / width;
    steps.push((context) => {
      const left = MARGIN + n * (wide + GAP);
      context.translate(left, begun);
      context.scale(factor, factor);
      draw(context);
      context.scale(1 / factor, 1 / factor);
      context.translate(-left, -begun);
    });
    top = Math.max(top, begun + Math.ceil(height * factor) + 12);
  });
  let left = MARGIN;
  for (const { text, colour } of seen.key) {
    const long = 22 + text.length * LETTER * 14 + 14;
    if (left > MARGIN && left + long > WIDE - MARGIN) [left, top] = [MARGIN, top + 22];
    const [x, y] = [left, top];
    left += long;
    steps.push((context) => {
      context.fillStyle = seen.inks.line;
      context.fillRect(x, y, 14, 14);
      context.fillStyle = colour;
      context.fillRect(x + 1, y + 1, 12, 12);
      context.font = `14px ${FAMILY}`;
      context.fillStyle = seen.inks.ink;
      context.fillText(text, x + 20, y + 12);
    });
  }
  if (seen.key.length) top += 28;
  say(seen.numbers.map((number) => number.replaceAll(" ", "\u00a0")).join(",   "), 15, seen.inks.ink);
  const height = top + MARGIN - 8;
  return { width: WIDE, height, draw: (/** @type {any} */ context) => {
    context.fillStyle = seen.inks.paper;
    context.fillRect(0, 0, WIDE, height);
    for (const step of steps) step(context);
  } };
}

/** As SVG. @param {Seen} seen @param {(image: any) => string} [encoded] a data URL, outside a browser */
export function svg(seen, encoded) {
  const { width, height, draw } = composed(seen);
  const picture = new Svg(width, height, [seen.title || seen.line, seen.verdict.text].join(": "), encoded);
  draw(picture);
  return String(picture);
}

/** The name of a file that says the scene. @param {Seen} seen @param {string} kind */
export function named({ title, line }, kind) {
  const words = (title || line).normalize("NFKD").toLowerCase().match(/[a-z0-9]+/g) ?? ["scene"];
  return `gyrostat-${words.join("-").slice(0, 60)}.${kind}`;
}
