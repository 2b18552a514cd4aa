// A page in a hurry: questions change and answers come in any order; never is an answer of another question unmarked.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Answers, key } from "../../docs/try/app/answers.js";
import { nothing, scene, taken } from "../../docs/try/app/scene.js";
import { KINDS, questions } from "../../docs/try/app/state.js";
import { chance } from "./exact.js";

const POTENTIALS = ["m0*k3", "m0*k3^2", "U(k3)", "", "refused(", "constructor*k3", "__proto__*k3"];
const NAMES = { "m0*k3": ["I1", "m0"], "m0*k3^2": ["I1", "m0"], "U(k3)": ["I1", "dU"], "": ["I1"], "constructor*k3": ["constructor"],
  "__proto__*k3": ["__proto__"] };

/** What a library would say of a question: its kind and the question itself come back, so that they can be compared. */
function answer(kind, question) {
  const potential = (question.scene ?? question).potential ?? "";
  if (kind === "analysed") {
    if (potential === "refused(") return { of: key([kind, question]), error: "refused" };
    return { names: NAMES[potential].map((name) => ({ name })), equilibria: [], chosen: "E1", open: potential !== "",
      axes: NAMES[potential], of: key([kind, { ...question, equilibrium: "E1" }]) };
  }
  return { of: key([kind, question]), steps: [], names: NAMES[potential] };
}

test("in 1000 random interleavings no answer stands unmarked beside another question", async () => {
  let shown = 0, marked = 0;
  for (let seed = 1; seed <= 1000; seed++) {
    const dice = chance(seed), open = [], asked = Object.assign(nothing(), taken({ potential: "m0*k3", values: {} }));
    const ask = (kind) => (question) => new Promise((resolve) => {
      for (const other of open.filter((one) => one.kind === kind && dice.below(2))) {      // a newer one took its place
        open.splice(open.indexOf(other), 1);
        other.resolve(null);
      }
      open.push({ kind, question, resolve });
    });
    const named = { analysed(found) {
      if (found.chosen) asked.equilibrium = found.chosen;
      for (const { name } of found.names ?? []) asked.values[name] ??= "1";
      asked.axes = [...found.axes ?? [], ""].slice(0, 2);
      return scene(asked);
    } };
    const answers = new Answers(Object.fromEntries(KINDS.map((kind) => [kind, ask(kind)])), () => update(), named);
    const look = () => {
      for (const [kind, question] of Object.entries(questions(asked, answers, Number))) {
        const found = answers.of(kind);
        if (found) assert.equal(found.of, key([kind, question]), `seed ${seed}, ${kind}`);
        shown += Number(Boolean(found));
        marked += Number(answers.waiting(kind));
        if (question === null) assert.equal(found, undefined);
      }
    };
    const update = () => {
      for (const [kind, question] of Object.entries(questions(asked, answers, Number))) answers.follow(kind, question);
      look();
    };
    update();
    for (let n = 0; n < 40; n++) {
      const action = dice.below(8);
      if (action === 0) asked.texts.potential = dice.one(POTENTIALS);
      else if (action === 1) asked.values[dice.one(["I1", "m0", "dU"])] = dice.one(["1", "2", "1/0"]);
      else if (action === 2) asked.open[dice.one(["opened", "derived"])] = Boolean(dice.below(2));
      else if (action === 3) asked.copying = dice.one(["", "latex", "link"]);
      else if (action === 4 && dice.below(4) === 0) answers.forget(dice.one(KINDS));
      else if (open.length) {
        const [one] = open.splice(dice.below(open.length), 1);
        one.resolve(dice.below(9) ? answer(one.kind, one.question) : { of: key([one.kind, one.question]), error: "late" });
        await null;
        await null;
        look();
        continue;
      }
      update();
    }
    while (open.length) {                               // in the end everything is answered, and nothing is marked
      const one = open.pop();
      one.resolve(answer(one.kind, one.question));
      await null;
      await null;
    }
    for (const kind of KINDS) assert.equal(answers.waiting(kind), false, `seed ${seed}: ${kind} is never answered`);
  }
  assert.ok(shown > 10_000 && marked > 10_000, `${shown} shown, ${marked} marked`);
});
