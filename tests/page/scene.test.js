// What is asked, as a link, as a table and as an example.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { link, linked, nothing, numbered, scene, spun, taken } from "../../docs/try/app/scene.js";
import { chance } from "./exact.js";

const EXAMPLES = JSON.parse(readFileSync(new URL("../../docs/try/examples.json", import.meta.url), "utf8"));
const HOSTILE = ["a&b=c", "#", "%", "%zz", "+", "a b", "k3;k3", "=", "==x", "set=I1=2", "𝛼", "\u202e", "\ud800", "<script>", "\"'`", "\n",
  "null", "undefined", "toString", "__proto__", "constructor", "0", ""];

test("a link restores what is asked, whatever is typed", () => {
  const dice = chance(5);
  for (let n = 0; n < 300; n++) {
    const text = () => dice.below(2) ? dice.one(HOSTILE) : "m0*k3";
    const asked = Object.assign(nothing(), taken({ potential: text(), spin: dice.one(["pi3_0", "omega3_0"]),
      equilibrium: dice.one(["E1", "E3", "axis 1"]), inertia: dice.one([["I1", "I1", "I3"], [["A", "0", "0"], ["0", "B", "0"], ["0", "0", "C"]]]),
      gyrostatic_momentum: ["0", "0", "l"], orbit: dice.one([undefined, "omega0"]) }));
    for (let m = 0; m < 3; m++) asked.values[text().replaceAll("=", "") || "x"] = text();
    asked.axes = ["m0", "l"];
    const { table, axes } = linked(link(asked).slice(1));
    const again = Object.assign(nothing(), taken(table));
    const known = (one) => JSON.parse(JSON.stringify([scene(one), Object.entries(one.values)]).replace(/\\ud800/g, "\ufffd"));
    assert.deepEqual(known(again), known(asked));
    assert.deepEqual(axes, asked.axes);
    assert.equal(Object.getPrototypeOf(again.values), null);
  }
});

test("an address without a scene is none", () => {
  for (const address of ["", "x=1", "inertia=1", "chart-title"]) assert.equal(linked(address), null);
});

test("an example is known by its scene, whatever its numbers", () => {
  EXAMPLES.forEach(({ scene }, n) => {
    assert.equal(EXAMPLES[numbered(scene, EXAMPLES)].scene.potential, scene.potential);
    assert.equal(numbered({ ...scene, values: {} }, EXAMPLES), n);
    assert.equal(numbered({ ...scene, potential: "m0*k3^3" }, EXAMPLES), -1);
    assert.equal(numbered(linked(link(Object.assign(nothing(), taken(scene))).slice(1)).table, EXAMPLES), n);
  });
});

test("an example is asked as its table says", () => {
  for (const { scene: table } of EXAMPLES) {
    const { values, ...known } = table, asked = scene(Object.assign(nothing(), taken(table)));
    for (const [name, value] of Object.entries(known)) {
      if (name !== "potential" || value) assert.deepEqual(String(asked[name]), name === "orbit" && typeof value === "object"
        ? Object.entries(value).map((pair) => pair.join("=")).join(", ") : String(value), name);
    }
    assert.equal("values" in asked, false);
    assert.ok(values);
  }
});

test("the same spin is said by its momentum, or by its rate", () => {
  const values = { I3: "1.6", omega3_0: "1.5" };
  spun({ values, spin: "pi3_0" });
  assert.equal(values.pi3_0, "1.5*1.6");
  spun({ values, spin: "omega3_0" });
  assert.equal(values.omega3_0, "1.5");                 // there and back it is as it was typed
  values.pi3_0 = "3";
  spun({ values, spin: "omega3_0" });
  assert.equal(values.omega3_0, "3/1.6");
  values.pi3_0 = "sqrt(2)";
  spun({ values, spin: "omega3_0" });
  assert.equal(values.omega3_0, "3/1.6");               // of what is no plain number nothing is made
});
