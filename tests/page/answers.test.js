// What is asked and what is answered: never an answer unmarked beside another question.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Answers, key } from "../../docs/try/app/answers.js";
import { nothing, scene, taken } from "../../docs/try/app/scene.js";
import { questions } from "../../docs/try/app/state.js";

/** Questions that are answered when the test says so. */
function desk(named = {}) {
  const open = [];
  const ask = (question) => new Promise((answer) => open.push({ question, answer }));
  const settled = [];
  const answers = new Answers({ decided: ask, analysed: ask }, () => settled.push(key(answers.answered)), named);
  return { answers, open, settled };
}

test("an answer stands beside its own question alone", async () => {
  const { answers, open } = desk();
  answers.follow("decided", { I1: "1" });
  assert.equal(answers.of("decided"), undefined);
  open[0].answer({ verdict: "STABLE" });
  await null;
  assert.deepEqual(answers.of("decided"), { verdict: "STABLE" });
  answers.follow("decided", { I1: "2" });
  assert.equal(answers.of("decided"), undefined);
  assert.deepEqual(answers.answered.decided.answer, { verdict: "STABLE" });      // shown, and marked
  assert.equal(answers.waiting("decided"), true);
});

test("an answer that comes too late is dropped", async () => {
  const { answers, open, settled } = desk();
  answers.follow("decided", 1);
  answers.follow("decided", 2);
  open[0].answer({ verdict: "of one" });
  await null;
  assert.equal(answers.answered.decided, undefined);
  open[1].answer({ verdict: "of two" });
  await null;
  assert.equal(answers.of("decided").verdict, "of two");
  assert.equal(settled.length, 1);
});

test("without a question there is no answer, and nothing is waited for", async () => {
  const { answers, open } = desk();
  answers.follow("decided", 1);
  open[0].answer({});
  await null;
  answers.follow("decided", null);
  assert.equal(answers.answered.decided, undefined);
  assert.equal(answers.waiting("decided"), false);
  answers.follow("decided", undefined);                 // not known yet
  assert.equal(answers.waiting("decided"), true);
});

test("a question has its full name when the library has chosen", async () => {
  const { answers, open } = desk({ analysed: (found) => ({ equilibrium: found.chosen }) });
  answers.follow("analysed", { equilibrium: "" });
  open[0].answer({ chosen: "E1" });
  await null;
  answers.follow("analysed", { equilibrium: "E1" });
  assert.equal(open.length, 1);
  assert.equal(answers.of("analysed").chosen, "E1");
});

test("what is forgotten is asked again, and marked until it comes", async () => {
  const { answers, open } = desk();
  answers.follow("decided", 1);
  open[0].answer({ n: 1 });
  await null;
  answers.forget("decided");
  assert.equal(answers.waiting("decided"), true);
  answers.follow("decided", 1);
  assert.equal(open.length, 2);
});

test("the questions of a page follow from what is asked and answered", async () => {
  const asked = Object.assign(nothing(), taken({ potential: "m0*k3", equilibrium: "E1", values: { I1: "1", m0: "2", x: "3" } }));
  const { answers, open } = desk();
  const now = () => questions(asked, answers, (_, text) => Number(text));
  assert.deepEqual(now().analysed, scene(asked));
  assert.equal(now().decided, undefined);               // not known: the names are not
  answers.follow("analysed", now().analysed);
  open[0].answer({ names: [{ name: "I1" }, { name: "m0" }], open: false });
  await null;
  assert.deepEqual(now().decided.values, { I1: "1", m0: "2" });
  assert.equal(now().opened, null);
  assert.equal(now().derived, null);
  asked.open.derived = true;
  assert.deepEqual(now().derived, scene(asked));
  asked.texts.potential = "m0*k3^2";
  assert.equal(now().decided, undefined);
});

test("a scene that is refused has no further questions", async () => {
  const asked = Object.assign(nothing(), taken({ potential: "bad(" }));
  const { answers, open } = desk();
  const now = () => questions(asked, answers, Number);
  answers.follow("analysed", now().analysed);
  open[0].answer({ error: "not part of the grammar" });
  await null;
  const { analysed, ...others } = now();
  assert.ok(analysed);
  assert.deepEqual(new Set(Object.values(others)), new Set([null]));
});

/** Answers of which one is prepared. */
function prepared(early) {
  const open = [], differed = [];
  const ask = (question) => new Promise((answer) => open.push({ question, answer }));
  const answers = new Answers({ decided: ask }, () => {}, {}, async () => early, (kind) => differed.push(kind));
  return { answers, open, differed };
}
const soon = () => new Promise((next) => setTimeout(next));

test("what was prepared is shown and marked until the library confirms it", async () => {
  const { answers, open, differed } = prepared({ verdict: "STABLE" });
  answers.follow("decided", { I1: "1" });
  await soon();
  assert.equal(answers.of("decided").verdict, "STABLE");
  assert.ok(answers.answered.decided.prepared);
  const shown = answers.answered.decided;
  open[0].answer({ verdict: "STABLE" });
  await soon();
  assert.equal(answers.answered.decided, shown);         // nothing is drawn again
  assert.equal(shown.prepared, undefined);
  assert.deepEqual(differed, []);
});

test("the library's answer takes the place of a prepared one that differs, and this is told", async () => {
  const { answers, open, differed } = prepared({ verdict: "STABLE" });
  answers.follow("decided", 1);
  await soon();
  open[0].answer({ verdict: "UNSTABLE" });
  await soon();
  assert.equal(answers.of("decided").verdict, "UNSTABLE");
  assert.equal(answers.answered.decided.prepared, undefined);
  assert.deepEqual(differed, ["decided"]);
});

test("a library that is lost leaves what was prepared, and its mark", async () => {
  const { answers, open, differed } = prepared({ verdict: "STABLE" });
  answers.follow("decided", 1);
  await soon();
  open[0].answer({ lost: true, error: "not running" });
  await soon();
  assert.equal(answers.of("decided").verdict, "STABLE");
  assert.ok(answers.answered.decided.prepared);
  assert.deepEqual(differed, []);
});

test("what was prepared comes too late behind the library, and beside another question", async () => {
  let give;
  const early = new Promise((resolve) => { give = resolve; });
  const { answers, open } = prepared(early);
  answers.follow("decided", 1);
  open[0].answer({ verdict: "of the library" });
  await soon();
  answers.follow("decided", 2);
  give({ verdict: "prepared" });
  await soon();
  assert.equal(answers.answered.decided.answer.verdict, "prepared");           // of 2, which was prepared too
  open[1].answer({ verdict: "prepared" });
  await soon();
  assert.equal(answers.answered.decided.prepared, undefined);
});
