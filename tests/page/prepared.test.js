// A prepared answer is found by its question alone.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { library } from "../../docs/try/app/prepared.js";
import { prepared } from "../../docs/try/prepare.mjs";

const EXAMPLES = JSON.parse(readFileSync(new URL("../../docs/try/examples.json", import.meta.url), "utf8"));
/** A library that answers each question with the question. */
const echo = (asked) => asked.want === "analysed"
  ? { equilibria: [], chosen: asked.scene.equilibrium ?? "point", names: Object.keys(EXAMPLES[0].scene.values).map((name) => ({ name })),
    axes: ["a", "b", "c"], asked }
  : { asked };

test("the page's own questions are prepared, and each is found again", async () => {
  const found = await prepared(EXAMPLES[0], echo);
  assert.deepEqual(Object.keys(found).sort(), ["analysed", "charted", "decided", "moving", "survived"]);
  assert.deepEqual(found.charted.question.axes, ["b", "c"]);
  const files = [], answer = library(async () => EXAMPLES, async (n) => {
    files.push(n);
    return found;
  });
  for (const [kind, { question, answer: expected }] of Object.entries(found)) {
    assert.deepEqual(await answer(kind, question), expected);
  }
  assert.deepEqual(files, [0]);                         // fetched once
});

test("another number, another axis and another scene have no prepared answer", async () => {
  const found = await prepared(EXAMPLES[0], echo), answer = library(async () => EXAMPLES, async () => found);
  const { question } = found.decided;
  assert.equal(await answer("decided", { ...question, values: { ...question.values, l: "1" } }), undefined);
  assert.equal(await answer("charted", { ...found.charted.question, axes: ["a", "c"] }), undefined);
  assert.equal(await answer("analysed", { ...found.analysed.question, potential: "m0*k3^2" }), undefined);
});

test("a file that does not come is no failure of the page", async () => {
  const answer = library(async () => EXAMPLES, () => Promise.reject(new Error("404")));
  const { analysed } = await prepared(EXAMPLES[0], echo);
  assert.equal(await answer("analysed", analysed.question), undefined);
});
