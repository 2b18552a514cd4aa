// The scales that sliders and chart share: that they fit their numbers, and keep still.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fitted, fitting, isLogarithmic, nice, numberAt, rounded, stepOf, steps, stretched, widened,
  written } from "../../docs/try/views/scales.js";

const NAMES = { I1: [1, 0, 0], I2: [1, 0, 0], I3: [1, 0, 0], l: [1, 1, 0], m0: [1, 2, 0], omega3_0: [0, 1, 0],
  omega0: [0, 1, 0], k3: [0, 0, 0], M: [1, 1, 0], J3: [1, 0, 1], c: null };
const name = (one) => ({ name: one, positive: /^(I\d|omega0)$/.test(one), dimension: NAMES[one] ?? null });
const number = (values) => (one) => values[one] ?? NaN;
const scalesOf = (values, old = new Map()) => fitted(old, Object.keys(values).map(name), number(values));
const ends = (scales, one) => scales.get(one).ends;
const scale = (one, ends, whole = ends) => ({ of: name(one), ends, whole, open: false });
const open = (scales) => new Map([...scales].map(([one, scale]) => [one, { ...scale, open: true }]));

test("a positive number has a twentieth and five times of it, rounded to a digit", () => {
  for (const [value, expected] of [[1, [0.05, 5]], [1.6, [0.1, 10]], [0.002, [0.0001, 0.01]],
    [0.0011, [0.00005, 0.005]], [398600, [20000, 2e6]], [3, [0.15, 15]], [2.2e-12, [1e-13, 1e-11]]]) {
    assert.deepEqual(fitting(name("I1"), value, 1), expected);
  }
  assert.deepEqual(fitting(name("M"), 2, 1), [0.1, 10]);
});

test("another number has as much below 0 as above", () => {
  for (const [value, expected] of [[1, 5], [1.5, 5], [2, 5], [-2.5, 10], [1e-6, 5e-6], [0.3, 1], [80, 200]]) {
    assert.deepEqual(fitting(name("l"), value, 1), [-expected, expected]);
  }
});

test("a component of a unit vector has -1 and 1, a parameter k any", () => {
  for (const one of ["k1", "k3", "n2", "r3"]) assert.deepEqual(fitting({ name: one }, 0.001, 1), [-1, 1]);
  assert.deepEqual(fitting({ name: "k3" }, 3, 1), [-10, 10]);
  assert.deepEqual(fitting({ name: "k" }, 50, 1), [-200, 200]);
});

test("a CubeSat fits its scales, its wheel that stands still too", () => {
  const scales = scalesOf({ I1: 0.002, I2: 0.0021, I3: 0.0018, l: 0, omega0: 0.0011 });
  assert.deepEqual(ends(scales, "I1"), [0.0001, 0.01]);
  assert.deepEqual(ends(scales, "omega0"), [0.00005, 0.005]);
  const [low, high] = ends(scales, "l");              // 0.002 kg m² times 0.0011 s⁻¹ is 2.2e-6
  assert.ok(low === -high && high >= 2.2e-6 && high <= 2.2e-5, String(high));
  assert.deepEqual(ends(scalesOf({ I1: 0.002, l: 1e-6, omega0: 0.0011 }), "l"), [-5e-6, 5e-6]);
});

test("what is 0 has a scale of its dimension", () => {
  const scales = scalesOf({ I1: 10, I3: 10, m0: 0, omega3_0: 0, l: 2000 });     // a rate of 200
  assert.deepEqual(ends(scales, "omega3_0"), [-500, 500]);
  assert.deepEqual(ends(scales, "m0"), [-1e6, 1e6]);
  assert.deepEqual(ends(scalesOf({ l: 0, c: 0, k3: 0, J3: 0 }), "c"), [-5, 5]);
  assert.deepEqual(ends(scalesOf({ l: 0, I1: 1 }), "l"), [-5, 5]);
});

test("a scale is made anew where a typed number is not seen on it, and else keeps still", () => {
  const old = scalesOf({ I1: 1, l: 1 });
  assert.deepEqual(scalesOf({ I1: 4.9, l: 1 }, open(old)).get("I1"), old.get("I1"));
  assert.deepEqual(ends(scalesOf({ I1: 0.002, l: 1 }, open(old)), "I1"), [0.0001, 0.01]);
  assert.deepEqual(ends(scalesOf({ I1: 1, l: 1e-6 }, open(old)), "l"), [-5e-6, 5e-6]);
  assert.deepEqual(ends(scalesOf({ I1: 1, l: 0 }, open(old)), "l"), [-5, 5]);
  assert.deepEqual(ends(scalesOf({ I1: 7, l: 1 }, old), "I1"), [0.05, 5]);      // nothing was typed
});

test("a number that is not known yet has a scale until it is", () => {
  const unknown = scalesOf({ I1: NaN, l: 1 });
  assert.ok(unknown.get("I1").open);
  const heard = scalesOf({ I1: 120, l: 1 }, unknown);
  assert.deepEqual(heard.get("I1"), { of: name("I1"), ends: [5, 500], whole: [5, 500], open: false });
});

test("a link says the ends, and the whole range stays that of the number", () => {
  const names = ["I1", "l"].map(name), values = number({ I1: 1, l: 1 });
  const found = fitted(new Map(), names, values, { I1: ["0.5", "2"], l: ["0", "3"], c: ["1", "2"] });
  assert.deepEqual(found.get("I1"), scale("I1", [0.5, 2], [0.05, 5]));
  assert.deepEqual(found.get("l"), scale("l", [0, 3], [-5, 5]));
  assert.equal(found.size, 2);
  assert.deepEqual(fitted(found, names, values, { l: ["1", "2"] }), found);
  for (const wrong of [["0", "2"], ["-1", "2"], ["2", "1"], ["a", "b"], ["1"], ["1", "1e999"], ["1", "1"]]) {
    assert.deepEqual(ends(fitted(new Map(), names, values, { I1: wrong }), "I1"), [0.05, 5]);
  }
});

test("scales of other names stay", () => {
  const old = scalesOf({ I1: 1, l: 3 });
  assert.deepEqual(scalesOf({ c: 1 }, old).get("l"), old.get("l"));
});

test("a name of JavaScript's own objects has a scale", () => {
  const found = fitted(new Map(), ["__proto__", "constructor"].map(name), () => 2);
  assert.deepEqual(ends(found, "__proto__"), [-5, 5]);
  assert.deepEqual(ends(found, "constructor"), [-5, 5]);
});

test("an end that is reached moves on, the other one stays", () => {
  assert.deepEqual(widened(scale("I1", [0.05, 5]), 5).ends, [0.05, 25]);
  assert.deepEqual(widened(scale("I1", [0.05, 5]), 0.05).ends, [0.0025, 5]);
  assert.deepEqual(widened(scale("l", [-5, 5]), -5).ends, [-20, 20]);
  assert.deepEqual(widened(scale("k3", [-1, 1]), 1).ends, [-1, 1]);
});

test("slider and number agree to three digits", () => {
  for (const pair of [[0.05, 5], [0.0001, 0.01], [20000, 2e6], [0.05, 25]]) {
    assert.ok(isLogarithmic(pair));
    for (let step = 0; step <= steps(pair); step++) {
      const value = numberAt(pair, step);
      assert.equal(stepOf(pair, value), step);
      assert.equal(Number(value.toPrecision(3)), value);
    }
    for (const value of [pair[0] * 1.2345, pair[1] / 3]) {
      assert.ok(Math.abs(numberAt(pair, stepOf(pair, value)) / value - 1) < 0.012);
    }
  }
  for (const pair of [[-5, 5], [-1, 1], [-5e-6, 5e-6], [1.2291, 1.2391], [-1e6, 1e6], [3, 4.0001]]) {
    assert.ok(!isLogarithmic(pair));
    assert.ok(steps(pair) >= 200 && steps(pair) <= 2001, String(steps(pair)));
    for (let step = 0; step <= steps(pair); step++) assert.equal(stepOf(pair, numberAt(pair, step)), step);
  }
  assert.equal(numberAt([-5, 5], stepOf([-5, 5], 1.23)), 1.23);
});

test("a step of a slider is always another number", () => {
  for (const pair of [[0.05, 5], [0.0001, 0.01], [-5, 5], [0.3, 2.9], [-2e-6, 7e-6]]) {
    const found = Array.from({ length: steps(pair) + 1 }, (_, step) => written(numberAt(pair, step)));
    assert.equal(new Set(found).size, found.length);
  }
});

test("a number is written as a visitor would type it", () => {
  for (const [value, text] of [[0.0021, "0.0021"], [2.2e-6, "2.2e-6"], [0, "0"], [-0.5, "-0.5"], [398600, "398600"],
    [-1e-7, "-1e-7"], [1.21, "1.21"]]) assert.equal(written(value), text);
});

test("zoom keeps the number under the pointer", () => {
  let zoomed = scale("l", [-5, 5]);
  for (const [at, factor] of [[0.3, 0.5], [0.8, 0.7], [0.1, 0.01], [0.5, 1.4], [0.9, 0.9]]) {
    const [low, high] = zoomed.ends, under = low + (high - low) * at;
    zoomed = stretched(zoomed, at, at, factor);
    const [first, last] = zoomed.ends;
    assert.ok(Math.abs((under - first) / (last - first) - at) < 2e-4);
    assert.ok(Math.abs((last - first) / (high - low) / factor - 1) < 2e-4);
    assert.ok(String(first).length < 12, String(first));
  }
});

test("zoom has limits, and positive names stay positive", () => {
  const zoomed = (pair, one, at, factor, times) => {
    let found = scale(one, pair);
    for (let n = 0; n < times; n++) found = stretched(found, at, at, factor);
    return found.ends;
  };
  const [low, high] = zoomed([0.05, 5], "I1", 0.5, 0.5, 99);
  assert.ok(low > 2 && low < high && high < 3 && high - low > 1e-4);
  assert.equal(zoomed([0.05, 5], "I1", 0.5, 2, 3)[0], 0.05);
  for (const factor of [1.1, 2, 3, 7]) {
    const [first, last] = zoomed([0.05, 5], "I1", 0.5, factor, 99);
    assert.ok(first > 0 && last <= 500);
  }
  assert.deepEqual(zoomed([-1, 1], "k3", 0.2, 2, 9), [-1, 1]);
  const zero = zoomed([-5, 5], "l", 0.5, 0.5, 99);
  assert.ok(zero[0] < 0 && zero[1] > 0 && zero[1] - zero[0] > 9e-6);
});

test("what is moved keeps its length", () => {
  assert.deepEqual(stretched(scale("l", [1, 3], [-5, 5]), 0.25, 0.5, 1).ends, [0.5, 2.5]);
  assert.deepEqual(stretched(scale("I1", [0.05, 5]), 0.1, 0.9, 1).ends, [0.05, 5]);
  assert.deepEqual(stretched(scale("k3", [0.5, 1], [-1, 1]), 0.5, 0.1, 1).ends, [0.5, 1]);
});

test("what a picture sets has as many digits as it can tell", () => {
  assert.equal(rounded([-5, 5], 1.23456), 1.23);
  assert.equal(rounded([1e-4, 0.01], 0.00212345), 0.00212);
  assert.equal(rounded([-5, 5], 7), 5);
  assert.equal(nice(2.5), 5);
  assert.equal(nice(0.002), 0.002);
});
