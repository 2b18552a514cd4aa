// A picture is a PNG that others can read, with the colours of its codes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { inflateSync } from "node:zlib";
import { pictured, png } from "../../docs/try/pictures.mjs";

/** The chunks of a PNG by their names. */
function chunks(data) {
  const found = {};
  for (let at = 8; at < data.length; at += 12 + data.readUInt32BE(at)) {
    found[data.toString("latin1", at + 4, at + 8)] = data.subarray(at + 8, at + 8 + data.readUInt32BE(at));
  }
  return found;
}

test("rows stand from above, each code has its colour", () => {
  const { IHDR, PLTE, IDAT, IEND } = chunks(png(Uint8Array.of(1, 2, 3, 4), 2));
  assert.deepEqual([...IHDR], [0, 0, 0, 2, 0, 0, 0, 2, 8, 3, 0, 0, 0]);
  assert.deepEqual([...inflateSync(IDAT)], [0, 3, 4, 0, 1, 2]);
  assert.deepEqual([PLTE.length, IEND.length], [15, 0]);
});

test("a chart is stable where its criterion is: x > 0 to the right", () => {
  const steps = [["name", "x"], ["name", "y"], ["multiply", 0, 0]], margin = { margin: 0, strict: true, degenerate: [] };
  const answer = { steps, positive: [], sufficient: [[margin]], necessary: [[{ ...margin, strict: false }]], names: ["x", "y"] };
  const names = ["x", "y"].map((name) => ({ name, positive: false, dimension: null }));
  const [kind, data] = pictured({ analysed: { answer: { names } }, charted: { question: { axes: ["x", "y"] }, answer },
    decided: { question: { values: { x: "0", y: "1" } }, answer: { verdict: "STABLE" } } });
  const rows = inflateSync(chunks(data).IDAT);
  assert.equal(kind, "png");
  assert.deepEqual([rows[1], rows[64]], [2, 1]);
});

test("without a chart each equilibrium has a dot in the colour of its verdict", () => {
  const found = [{ verdict: "STABLE" }, { verdict: "UNSTABLE" }, { verdict: "STABLE" }];
  const [kind, data] = pictured({ decided: { question: {}, answer: { found } } });
  const inks = [...data.toString().matchAll(/fill="(#\w+)"/g)].map(([, ink]) => ink);
  assert.equal(kind, "svg");
  assert.ok(inks[0] === inks[2] && inks[0] !== inks[1]);
});
