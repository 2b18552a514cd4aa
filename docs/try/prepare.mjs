// The answers that the page shows of an example before the library is there: the page's own questions, asked when the
// page is built. The exact boundary of a chart is left to the library, for it depends on the ends of the axes.
import { Answers } from "./app/answers.js";
import { possible } from "./app/numbers.js";
import { nothing, scene, taken } from "./app/scene.js";
import { questions } from "./app/state.js";
import { paired } from "./views/axes.js";

const KINDS = ["analysed", "decided", "opened", "survived", "charted", "moving"];
const ROUNDS = 4;                                       // as far as an answer leads to another question

/**
 * Of each kind the question and its answer.
 * @param {any} example
 * @param {(question: { want: string, scene: any, more: any[] }) => any} answer
 * @returns {Promise<import("./app/prepared.js").Prepared>}
 */
export async function prepared(example, answer) {
  const asked = Object.assign(nothing(), taken(example.scene), { open: { opened: true } });
  const ask = Object.fromEntries(KINDS.map((want) => [want, async (/** @type {any} */ question) =>
    want === "charted" ? answer({ want, scene: question.scene, more: [question.axes] })
      : answer({ want, scene: question, more: [] })]));
  const answers = new Answers(ask, () => {}, { analysed: ({ equilibria, chosen, axes }) => {
    if (equilibria) asked.equilibrium = chosen;
    if (axes) asked.axes = paired(axes, asked.axes);
    return scene(asked);
  } });
  for (let round = 0; round < ROUNDS; round++) {
    const now = questions(asked, answers, possible);
    for (const kind of KINDS) answers.follow(kind, now[kind]);
    await new Promise((next) => setTimeout(next));
  }
  return Object.fromEntries(Object.entries(answers.answered).map(([kind, { question, answer: found }]) =>
    [kind, { question, answer: found }]));
}
