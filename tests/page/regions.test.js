// Codes of charts: what is coloured is true by exact arithmetic, and nearly all is coloured.
import assert from "node:assert/strict";
import { test } from "node:test";
import { NOWHERE, OPEN, Regions, STABLE, UNKNOWN, UNSTABLE } from "../../docs/try/numerics/regions.js";
import { chance, exactly, results, sign } from "./exact.js";

const SIZE = 12;
const X = 0, Y = 1, ONE = 2, STEPS = [["name", "x"], ["name", "y"], ["number", 1], ["multiply", X, X], ["multiply", Y, Y],
  ["add", 3, 4], ["subtract", 5, ONE], ["subtract", X, Y], ["multiply", X, Y]];
const RING = 6, SLOPE = 7, SADDLE = 8;                  // x² + y² - 1, x - y, xy
const condition = (margin, strict, degenerate = []) => ({ margin, strict, degenerate });
const always = [[condition(ONE, true)]];

/** What is true at a point: of each criterion whether it holds; a condition that is not strict is met on its boundary. */
function truth(chart, x, y) {
  const exact = results(chart.steps, { x: exactly(x), y: exactly(y) });
  const holds = ({ margin, strict, degenerate }) => {
    const zero = degenerate.some((place) => sign(exact[place]) === 0), above = sign(exact[margin]);
    return strict ? above > 0 && !zero : above >= 0 || zero;
  };
  const met = (criterion) => criterion.some((conditions) => conditions.every(holds));
  return { exists: chart.positive.every((place) => sign(exact[place]) > 0), sufficient: met(chart.sufficient),
    necessary: met(chart.necessary) };
}

/** The points of a chart and their codes. */
function drawn(chart, ends) {
  const codes = new Regions(chart, ["x", "y"], SIZE).drawn({}, ends), at = ([from, to], n) => from + (to - from) * (n + 0.5) / SIZE;
  return [...codes].map((code, n) => [at(ends[0], n % SIZE), at(ends[1], Math.floor(n / SIZE)), code]);
}

const ALLOWED = {
  [STABLE]: ({ exists, sufficient }) => exists && sufficient,
  [UNSTABLE]: ({ exists, necessary }) => exists && !necessary,
  [OPEN]: ({ exists, sufficient, necessary }) => exists && necessary && !sufficient,
  [NOWHERE]: ({ exists }) => !exists,
  [UNKNOWN]: () => true };

test("a disc is stable, outside it is unstable, the lowest row first", () => {
  const outside = [[condition(RING, true)]];
  const chart = { steps: [...STEPS, ["negative", RING]], positive: [], sufficient: [[condition(9, true)]], necessary: outside };
  for (const [x, y, code] of drawn(chart, [[-2, 2], [-2, 3]])) {
    assert.equal(code, x * x + y * y < 1 ? STABLE : OPEN, `${x}, ${y}`);
  }
  const other = { ...chart, necessary: [[condition(9, false)]] };
  for (const [x, y, code] of drawn(other, [[-2, 2], [-2, 3]])) assert.equal(code, x * x + y * y < 1 ? STABLE : UNSTABLE);
});

test("where something that must be positive is negative there is no equilibrium", () => {
  const chart = { steps: STEPS, positive: [X, SLOPE], sufficient: always, necessary: always };
  for (const [x, y, code] of drawn(chart, [[-3, 5.3], [-2, 5.1]])) assert.equal(code, x > 0 && x > y ? STABLE : NOWHERE);
});

test("on a boundary nothing is known", () => {
  const chart = { steps: STEPS, positive: [], sufficient: [[condition(SLOPE, true)]], necessary: [[condition(SLOPE, false)]] };
  for (const [x, y, code] of drawn(chart, [[-1, 1], [-1, 1]])) {
    assert.equal(code, x === y ? UNKNOWN : x > y ? STABLE : UNSTABLE);
  }
});

test("an even factor that vanishes breaks a strict condition, and meets the other", () => {
  const chart = { steps: STEPS, positive: [], sufficient: [[condition(ONE, true, [SADDLE])]], necessary: always };
  for (const [, , code] of drawn(chart, [[-1, 1], [-1, 1]])) assert.equal(code, STABLE);
  const steps = [...STEPS, ["subtract", X, X], ["negative", ONE]], met = [[condition(10, false, [9])]];
  for (const [, , code] of drawn({ ...chart, steps, sufficient: [[condition(10, true)]], necessary: met }, [[0, 1], [0, 1]])) {
    assert.equal(code, UNKNOWN);                        // of a zero the sign is not known
  }
});

test("of a polynomial that loses its digits nothing is said that is not so", () => {
  const steps = [["name", "x"], ["name", "y"], ["number", 2 ** 20 + 0.1], ["add", 0, 2], ["subtract", 0, 2], ["multiply", 3, 4],
    ["multiply", 2, 2], ["add", 5, 6], ["multiply", 1, 1], ["subtract", 7, 8]];            // (x + c)(x - c) + c² - y²
  const chart = { steps, positive: [], sufficient: [[condition(9, true)]], necessary: [[condition(9, false)]] };
  for (const [far, known] of [[2e-5, false], [0.1, true]]) {
    const codes = drawn(chart, [[-far, far], [-far, 1.1 * far]]);
    for (const [x, y, code] of codes) assert.ok(ALLOWED[code](truth(chart, x, y)), `${code} at ${x}, ${y}`);
    assert.equal(codes.some(([, , code]) => code !== UNKNOWN), known);
  }
});

test("no pixel of 300 random charts contradicts exact arithmetic, and most are known", () => {
  const dice = chance(7), places = [X, Y, ONE, RING, SLOPE, SADDLE, 9, 10];
  const steps = [...STEPS, ["negative", RING], ["divide", ONE, 5]];
  const criterion = () => Array.from({ length: 1 + dice.below(2) }, () => Array.from({ length: 1 + dice.below(3) }, () =>
    condition(dice.one(places), Boolean(dice.below(2)), dice.below(3) ? [] : [dice.one(places)])));
  const seen = new Map();
  for (let n = 0; n < 300; n++) {
    const chart = { steps, positive: dice.below(2) ? [dice.one(places)] : [], sufficient: criterion(), necessary: criterion() };
    const ends = [[-2 - dice.random(), 2], [-2, 2 + dice.random()]];
    for (const [x, y, code] of drawn(chart, ends)) {
      assert.ok(ALLOWED[code](truth(chart, x, y)), `chart ${n}: ${code} at ${x}, ${y}: ${JSON.stringify(chart)}`);
      seen.set(code, (seen.get(code) ?? 0) + 1);
    }
  }
  const all = 300 * SIZE ** 2;
  assert.ok((seen.get(UNKNOWN) ?? 0) < 0.25 * all, `${seen.get(UNKNOWN)} of ${all}`);
  for (const code of [STABLE, UNSTABLE, OPEN, NOWHERE]) assert.ok(seen.get(code) > 0.02 * all, `${[...seen]}`);
});
