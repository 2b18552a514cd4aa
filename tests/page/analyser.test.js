// The questions to the library: one at a time, the newest of each kind, and what becomes of them where it fails.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

const workers = [];
globalThis.Worker = class {
  constructor() {
    this.questions = [];
    this.ended = false;
    workers.push(this);
  }

  postMessage(message) {
    this.questions.push(message);
  }

  terminate() {
    this.ended = true;
  }

  /** It says something. */
  say(data) {
    this.onmessage({ data });
  }

  /** It answers its last question. */
  answer(found) {
    this.say({ id: this.questions.at(-1).id, answer: JSON.stringify(found) });
  }
};
const { Analyser, LIMIT } = await import("../../docs/try/app/analyser.js");

beforeEach(() => workers.splice(0));

/** An analyser, its worker, and what the page is told. */
function begun() {
  const told = [], analyser = new Analyser();
  analyser.listen((news) => told.push(news));
  analyser.start();
  return { analyser, told, worker: workers.at(-1) };
}
const asked = (worker) => worker.questions.map(({ question }) => JSON.parse(question));

test("nothing is asked before the library is ready, then one question at a time", async () => {
  const { analyser, told, worker } = begun();
  const first = analyser.ask("analysed", { n: 1 }), second = analyser.ask("decided", { n: 2 }, ["more"]);
  worker.say({ step: "packages" });
  assert.equal(worker.questions.length, 0);
  worker.say({ ready: true });
  assert.deepEqual(asked(worker), [{ want: "analysed", scene: { n: 1 }, more: [] }]);
  worker.answer({ found: 1 });
  assert.deepEqual(await first, { found: 1 });
  assert.deepEqual(asked(worker)[1], { want: "decided", scene: { n: 2 }, more: ["more"] });
  worker.answer({ found: 2 });
  assert.deepEqual(await second, { found: 2 });
  assert.deepEqual(told.slice(0, 2), [{ step: "packages" }, { ready: true }]);
});

test("of questions of one kind that wait the newest is asked, and the others are given up", async () => {
  const { analyser, worker } = begun();
  worker.say({ ready: true });
  const now = analyser.ask("decided", { n: 0 });        // it is being answered
  const waiting = [1, 2, 3].map((n) => analyser.ask("decided", { n })), other = analyser.ask("charted", { n: 4 });
  assert.equal(await waiting[0], null);
  assert.equal(await waiting[1], null);
  worker.answer({ of: 0 });
  assert.deepEqual(await now, { of: 0 });
  worker.answer({ of: 3 });
  assert.deepEqual(await waiting[2], { of: 3 });
  worker.answer({ of: 4 });
  assert.deepEqual(await other, { of: 4 });
  assert.deepEqual(asked(worker).map(({ scene }) => scene.n), [0, 3, 4]);
});

test("an answer to another question than the one that is asked is dropped", async () => {
  const { analyser, worker } = begun();
  worker.say({ ready: true });
  const answer = analyser.ask("decided", {}), { id } = worker.questions[0];
  worker.say({ id: id + 1, answer: '{"of": "another"}' });
  worker.say({ id: id - 1, answer: '{"of": "another"}' });
  worker.say({ id, answer: '{"of": "this"}' });
  assert.deepEqual(await answer, { of: "this" });
  assert.equal(analyser.asked, null);
});

test("a question that takes too long is ended, and the next one is asked of a new worker", async ({ mock }) => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const { analyser, worker } = begun();
  worker.say({ ready: true });
  const late = analyser.ask("decided", { n: 1 }), next = analyser.ask("charted", { n: 2 });
  mock.timers.tick(LIMIT * 1000 - 1);
  assert.equal(worker.ended, false);
  mock.timers.tick(1);
  assert.match((await late).error, /longer than 10 s/);
  assert.ok(worker.ended && workers.length === 2);
  worker.answer({ of: 1 });                             // what the old one says now is nothing
  workers[1].say({ ready: true });
  workers[1].answer({ of: 2 });
  assert.deepEqual(await next, { of: 2 });
  mock.timers.tick(LIMIT * 1000);
  assert.equal(workers.length, 2);                      // an answer ends the clock
});

test("a worker that fails at a question is started again; one that fails at its start is not", async () => {
  const { analyser, told, worker } = begun();
  worker.say({ ready: true });
  const answer = analyser.ask("decided", {});
  worker.onerror({ preventDefault() {}, message: "out of memory" });
  assert.match((await answer).error, /out of memory/);
  const [, again] = workers, waiting = analyser.ask("decided", {});
  again.say({ failed: "python.zip: 404" });
  assert.equal((await waiting).lost, true);
  assert.equal((await analyser.ask("charted", {})).lost, true);
  assert.ok(again.ended && analyser.lost && workers.length === 2);
  assert.deepEqual(told.at(-1), { failed: "python.zip: 404" });
});

test("what is told before somebody listens is told then", () => {
  const told = [], analyser = new Analyser();
  analyser.start();
  workers[0].say({ step: "packages" });
  workers[0].say({ failed: "python.xz: 404" });
  analyser.listen((news) => told.push(news));
  assert.deepEqual(told, [{ step: "packages" }, { failed: "python.xz: 404" }]);
  analyser.start();
  workers[1].say({ ready: true });
  assert.deepEqual(told.slice(2), [{ ready: true }]);
});
