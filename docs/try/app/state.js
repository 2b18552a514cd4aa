// The questions of the page: from what is asked, and from what is answered already.
import { key } from "./answers.js";
import { scene } from "./scene.js";

/** Every kind of question, in the order in which the library is asked. */
export const KINDS = ["analysed", "decided", "opened", "survived", "derived", "copied", "charted", "edges", "moving"];
/** What is copied that the library writes. */
const TEXTS = ["latex", "python", "scene"];

/**
 * The question of each kind: null where the page has none, undefined while it is not known yet.
 * @param {import("./scene.js").Asked} asked
 * @param {import("./answers.js").Answers} answers
 * @param {(name: string, text: string) => number} number a text as a double, NaN of what is none
 * @returns {Record<string, any>}
 */
export function questions(asked, answers, number) {
  const here = scene(asked), analysed = standing(answers, "analysed", here);
  const known = analysed ? analysed.error ? null : here : undefined;
  const whole = known && { ...known, values: Object.fromEntries(names(analysed).map((name) => [name, asked.values[name]])) };
  const charted = known && { scene: known, axes: asked.axes };
  return {
    analysed: here,
    decided: whole,
    survived: whole,
    opened: analysed && !(analysed.open && asked.open.opened) ? null : whole,
    derived: asked.open.derived ? known : null,
    copied: TEXTS.includes(asked.copying) ? whole : null,
    charted,
    edges: charted && edges(standing(answers, "charted", charted), whole, asked, number),
    moving: known };
}

/** The names of the numbers that an answer needs. @param {any} analysed @returns {string[]} */
export const names = (analysed) => (analysed?.names ?? []).map((/** @type {{name: string}} */ { name }) => name);

/**
 * The answer to a question, if it has come.
 * @param {import("./answers.js").Answers} answers
 * @param {string} kind
 * @param {any} question
 */
function standing(answers, kind, question) {
  const found = answers.answered[kind];
  return found?.asked === key(question) ? found.answer : undefined;
}

/**
 * The question for the exact boundary of a chart: its axes have no numbers, and the others must be some.
 * @param {any} program
 * @param {any} whole
 * @param {import("./scene.js").Asked} asked
 * @param {(name: string, text: string) => number} number
 */
function edges(program, whole, { axes, scales, values }, number) {
  if (!program) return undefined;
  const others = Object.entries(whole.values).filter(([name]) => !axes.includes(name));
  const needed = (program.names ?? []).filter((/** @type {string} */ name) => !axes.includes(name));
  if (!program.steps || !needed.every((/** @type {string} */ name) => Number.isFinite(number(name, values[name])))) return null;
  return { scene: { ...whole, values: Object.fromEntries(others) }, axes,
    ends: axes.map((name) => scales.get(name)?.ends.map(String)) };
}
