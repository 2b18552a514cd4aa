// What the page says while the library starts.
import assert from "node:assert/strict";
import { test } from "node:test";
import { progress } from "../../docs/try/app/progress.js";

const parts = (...got) => ["Python", "FLINT", "SymPy"].map((name, n) => ({ name, got: got[n], of: 4e6 }));

test("bytes of all parts together, and the names of those that have not come", () => {
  assert.deepEqual(progress({ parts: parts(1e6, 0, 2e6) }), { share: 0.25, text: "3.0 of 12.0 MB: Python, FLINT and SymPy" });
  assert.equal(progress({ parts: parts(4e6, 4e6, 2e6) }).text, "10.0 of 12.0 MB: SymPy");
  assert.deepEqual(progress({ parts: parts(4e6, 4e6, 4e6) }), { share: 1, text: "all has come, Python starts" });
});

test("steps after that have no share", () => {
  assert.equal(progress({ step: "library" }).share, undefined);
  assert.notEqual(progress({ step: "packages" }).text, progress({ step: "library" }).text);
  assert.equal(progress({ ready: true }).text, "ready");
});
