// The axes of a chart: their names; where their ticks are, and that they can be read.
import assert from "node:assert/strict";
import { test } from "node:test";
import { paired, readable, ticked, titled } from "../../docs/try/views/axes.js";

const texts = (ends, most = 5) => ticked(ends, most).ticks.map(({ text }) => text);
const read = (text, power) => Number(text.replace("−", "-")) * 10 ** power;

test("the axes are two free names, the wanted ones if they can be", () => {
  const names = ["a", "b", "c", "d"], wanted = ["", "x", ...names];
  for (let free = [...names]; free.length; free = free.slice(1)) {
    for (const across of wanted) {
      for (const upwards of wanted) {
        const found = paired(free, [across, upwards]);
        assert.equal(new Set(found).size, 2);
        assert.deepEqual(found.filter((name) => !free.includes(name)), free.length > 1 ? [] : [""]);
        if (free.includes(across)) assert.equal(found[0], across);
        if (free.includes(upwards) && upwards !== across) assert.equal(found[1], upwards);
      }
    }
  }
  assert.deepEqual(paired(names, ["", ""]), ["c", "d"]);
  assert.deepEqual(paired(names, ["b", "b"]), ["b", "d"]);
  assert.deepEqual(paired(["a"], ["", ""]), ["a", ""]);
  assert.deepEqual(paired([], ["a", "b"]), ["", ""]);
});

// Ends of every size, of both signs, wide and narrow.
function* pairs() {
  for (let size = -9; size <= 9; size++) {
    for (const [low, high] of [[-5, 5], [0.05, 5], [1, 2.7], [-3.3, -0.2], [1.2291, 1.2391], [-1, 1], [0.0001, 0.01],
      [-0.3, 7.77], [4.99, 5.01]]) yield [low * 10 ** size, high * 10 ** size];
  }
}

test("ticks are inside, different, in order, 1, 2 or 5 times a power of ten apart", () => {
  for (const ends of pairs()) {
    for (const most of [3, 5, 8]) {
      const { ticks, step } = ticked(ends, most), near = (ends[1] - ends[0]) * 1e-9;
      assert.ok(["1", "2", "5"].includes((step * (1 + 1e-12)).toExponential(6)[0]), String(step));
      assert.ok(Math.abs(step / Number(step.toPrecision(1)) - 1) < 1e-9);
      assert.ok(ticks.length <= most + 1 && (most < 5 || ticks.length >= 2), `${ends}: ${ticks.length}`);
      assert.equal(new Set(ticks.map(({ text }) => text)).size, ticks.length);
      ticks.forEach(({ value }, n) => {
        assert.ok(value >= ends[0] && value <= ends[1]);
        if (n) assert.ok(Math.abs(value - ticks[n - 1].value - step) < near);
      });
    }
  }
});

test("a tick says its number", () => {
  for (const ends of pairs()) {
    const { ticks, power } = ticked(ends, 6), near = (ends[1] - ends[0]) * 1e-9;
    for (const { value, text } of ticks) {
      assert.ok(Math.abs(read(text, power) - value) <= near, `${text} ${power} ${value}`);
      assert.ok(text.length <= 8 && !/[e-]|^−?0\.?0*$/.test(text.replace(/^0$/, "")), text);
    }
  }
});

test("ticks are written as in a book", () => {
  assert.deepEqual(texts([-5, 5]), ["−4", "−2", "0", "2", "4"]);
  assert.deepEqual(texts([0.05, 5]), ["1", "2", "3", "4", "5"]);
  assert.deepEqual(texts([-1, 1]), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
  assert.deepEqual(texts([0.0001, 0.01]), ["0.002", "0.004", "0.006", "0.008", "0.010"]);
  assert.deepEqual(texts([-5e-6, 5e-6]), ["−4", "−2", "0", "2", "4"]);
  assert.equal(ticked([-5e-6, 5e-6], 5).power, -6);
});

test("ticks do not overlap, at the width of a phone too", () => {
  const room = (text) => 7 * text.length + 12;
  for (const ends of pairs()) {
    for (const length of [270, 400]) {
      const { ticks, step } = readable(ends, length, room), apart = step / (ends[1] - ends[0]) * length;
      for (const { text } of ticks) assert.ok(room(text) <= apart + 1e-9, `${text} ${apart}`);
      assert.ok(ticks.length >= 2, `${ends}`);
    }
  }
});

test("a title has the power of ten of its ticks", () => {
  assert.equal(titled("l", -6), "l in 10⁻⁶");
  assert.equal(titled("I₁", 12), "I₁ in 10¹²");
  assert.equal(titled("ω₃⁰", 0), "ω₃⁰");
});
