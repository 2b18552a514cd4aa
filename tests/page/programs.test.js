// Programs in doubles: the error of each result is within its bound, by exact arithmetic.
import assert from "node:assert/strict";
import { test } from "node:test";
import { compiled } from "../../docs/try/numerics/compiled.js";
import { Rows, SLACK } from "../../docs/try/numerics/programs.js";
import { absolute, add, below, chance, divide, exactly, multiply, nearest, ratio, results, subtract } from "./exact.js";

const NAMES = ["a", "b", "c", "x", "y"];

/** A number that is no double as a rule; sometimes tiny or huge. */
function drawn({ below, one }) {
  const digits = () => BigInt(1 + below(10 ** 9)) * BigInt(1 + below(10 ** 9));
  const scale = one([0, 0, 0, 0, 1, 20, 80, 300]);
  return ratio((below(2) ? 1n : -1n) * digits() * 2n ** BigInt(below(2) * scale), digits() * 2n ** BigInt(below(2) * scale));
}

/** A program of so many steps; a few of its differences are of numbers that are nearly the same. */
function program(dice, length, operations) {
  const steps = NAMES.map((name) => ["name", name]);
  const degrees = NAMES.map(() => 1);                   // exact results have as many digits
  while (steps.length < length) {
    const operation = dice.one(operations), a = dice.below(steps.length), b = dice.below(steps.length);
    const degree = operation === "number" ? 1 : operation === "negative" ? degrees[a] : degrees[a] + degrees[b];
    if (degree > 12) continue;
    degrees.push(degree);
    steps.push(operation === "number" ? ["number", dice.random() * 4 - 2]
      : operation === "negative" ? [operation, a] : [operation, a, b]);
  }
  return steps;
}

/** Whether a value is as near to the exact one as is said; an error that is not finite says nothing. */
function near(value, error, exact) {
  if (!(error * SLACK < Infinity)) return true;
  return exact !== null && !below(exactly(error * SLACK), absolute(subtract(exactly(value), exact)));
}

test("the nearest double of a rational number is nearest", () => {
  const dice = chance(1);
  for (let n = 0; n < 500; n++) {
    const x = dice.random() * 2 ** (dice.below(2090) - 1075);
    assert.equal(nearest(exactly(x)), x);
    assert.equal(nearest(multiply(exactly(x), ratio(2n ** 80n + 1n, 2n ** 80n))), x);
  }
  assert.equal(nearest(ratio(1n, 3n)), 1 / 3);
});

test("the error of every step of 1000 random programs is within its bound", () => {
  const dice = chance(2);
  let known = 0, all = 0;
  for (let n = 0; n < 1000; n++) {
    const steps = program(dice, 20, ["add", "subtract", "multiply", "divide", "negative", "number"]);
    const numbers = Object.fromEntries(NAMES.map((name) => [name, drawn(dice)]));
    const close = multiply(numbers.a, ratio(10n ** 12n + 1n, 10n ** 12n));
    if (n % 3 === 0) numbers.b = close;                 // a - b loses 12 digits
    const rows = new Rows(steps, [], 1);
    rows.begin(Object.fromEntries(NAMES.map((name) => [name, nearest(numbers[name])])), 0);
    results(steps, numbers).forEach((exact, i) => {
      const value = rows.values[i][0], error = rows.errors[i][0];
      assert.ok(near(value, error, exact), `program ${n}, ${JSON.stringify(steps.slice(0, i + 1))}: ${value} ± ${error}`);
      known += Number(error < Infinity && Math.abs(value) > error);
      all += 1;
    });
  }
  assert.ok(known > 0.9 * all, `${known} of ${all} signs are known`);
});

test("one error for all pixels bounds that of every pixel of a polynomial", () => {
  const dice = chance(3);
  for (let n = 0; n < 200; n++) {
    const steps = program(dice, 16, ["add", "subtract", "multiply", "negative", "number"]);
    const rows = new Rows(steps, ["x", "y"], 3), across = Float64Array.from({ length: 3 }, () => dice.random() * 8 - 4);
    assert.ok(rows.polynomial);
    const numbers = Object.fromEntries(NAMES.map((name) => [name, drawn(dice)]));
    const doubles = Object.fromEntries(NAMES.map((name) => [name, nearest(numbers[name])]));
    rows.begin({ ...doubles, x: across }, 4);
    for (const y of [-4, dice.random(), 4]) {
      rows.row(y, false);
      across.forEach((x, pixel) => {
        const exact = results(steps, { ...numbers, x: exactly(x), y: exactly(y) });
        steps.forEach((_, i) => {
          const row = rows.values[i], error = rows.kinds[i] > 1 ? rows.bounds[i] : rows.errors[i].at(pixel) ?? rows.errors[i][0];
          assert.ok(near(row[row.length > 1 ? pixel : 0], error, exact[i]), `program ${n}, step ${i}, x = ${x}, y = ${y}`);
        });
      });
    }
  }
});

test("a row has the values of its pixels, with errors and without", () => {
  const dice = chance(4);
  for (let n = 0; n < 200; n++) {
    const steps = program(dice, 16, ["add", "subtract", "multiply", "negative", "number", ...n % 2 ? [] : ["divide"]]);
    const across = Float64Array.from({ length: 3 }, () => dice.random() * 8 - 4), y = dice.random();
    const numbers = Object.fromEntries(NAMES.map((name) => [name, dice.random() * 4 - 2]));
    const rows = new Rows(steps, ["x", "y"], 3), value = compiled({ steps, results: steps.map((_, i) => i) });
    assert.equal(rows.polynomial || n % 2 === 0, true);
    rows.begin({ ...numbers, x: across }, 1);
    for (const errors of rows.polynomial ? [true, false] : [true]) {
      rows.row(y, errors);
      across.forEach((x, pixel) => {
        const alone = value({ ...numbers, x, y });
        rows.values.forEach((row, i) => assert.equal(row[row.length > 1 ? pixel : 0], alone[i]));
      });
    }
  }
});

test("a result whose divisor may be zero has no bound", () => {
  const steps = [["name", "a"], ["name", "b"], ["subtract", 0, 1], ["divide", 0, 2]];
  for (const [a, b] of [[1, 1], [1, 1 + 2 ** -52]]) {
    const rows = new Rows(steps, [], 1);
    rows.begin({ a, b }, 0);
    assert.ok(!(rows.errors[3][0] < Infinity));
  }
});

const WITHIN = { exp: 1, log: 2, sin: 1, cos: 1, tan: 1, asin: 0.5, acos: 0.5, atan: 2, sinh: 1, cosh: 1, tanh: 1, asinh: 1,
  acosh: 2, atanh: 0.5 };

test("each function has the value of the field's own name, and the bound of its slope", () => {
  for (const [name, at] of Object.entries(WITHIN)) {
    const steps = [["name", "a"], [name, 0]], rows = new Rows(steps, [], 1), f = Math[name];
    rows.begin({ a: at }, 0);
    assert.equal(rows.values[1][0], f(at));
    assert.deepEqual(compiled({ steps, results: [1] })({ a: at }), [f(at)]);
    const slope = Math.abs(f(at + 1e-6) - f(at - 1e-6)) / 2e-6, most = ["sin", "cos", "atan", "tanh", "asinh"].includes(name)
      ? 1 : 1.3 * slope;
    const bound = 2 ** -53 * (most * at + 8 * Math.abs(f(at)));          // of the argument, and of the function
    assert.ok(rows.errors[1][0] > 2 ** -53 * (0.999 * slope * at + 7.999 * Math.abs(f(at))), name);
    assert.ok(rows.errors[1][0] <= bound * SLACK, `${name}: ${rows.errors[1][0]} is more than ${bound}`);
  }
  assert.deepEqual(compiled({ steps: [["name", "a"], ["power", 0, 1.5]], results: [1] })({ a: 4 }), [8]);
});

test("a root of a difference that has lost its digits is within its bound", () => {
  const dice = chance(6), power = (x, n) => n < 0 ? divide([1n, 1n], power(x, -n)) : n ? multiply(x, power(x, n - 1)) : [1n, 1n];
  let known = 0;
  for (let n = 0; n < 400; n++) {
    const x = ratio(BigInt(1 + dice.below(10 ** 9)), BigInt(1 + dice.below(10 ** 9)) * 10n ** BigInt(dice.below(12)));
    const big = ratio(BigInt(1 + dice.below(10 ** 9)), BigInt(1 + dice.below(10 ** 9))), [p, q] = dice.one([[1, 2], [3, 2], [-1, 2], [1, 3], [-5, 3]]);
    const rows = new Rows([["name", "a"], ["name", "b"], ["subtract", 0, 1], ["power", 2, p / q]], [], 1);
    rows.begin({ a: nearest(add(big, x)), b: nearest(big) }, 0);
    const value = rows.values[3][0], error = rows.errors[3][0] * SLACK;
    if (!(error < value)) continue;
    known += 1;
    const truth = power(x, p), [least, greatest] = [value - error, value + error].map((end) => power(exactly(end), q));
    assert.ok(!below(truth, least) && !below(greatest, truth), `(${x[0]}/${x[1]})^(${p}/${q}) is not ${value} ± ${error}`);
  }
  assert.ok(known > 200, `${known}`);
});
