// Motions whose solutions are known.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Motion } from "../../docs/try/numerics/integrator.js";

const near = (found, expected, tolerance) => found.forEach((x, n) => assert.ok(Math.abs(x - expected[n]) <= tolerance,
  `${found} is not ${expected}`));

test("an oscillator follows cosine and sine for a hundred periods", () => {
  const motion = new Motion(([x, v]) => [v, -x], [1, 0]);
  for (let n = 1; n <= 100; n++) near(motion.at(2 * Math.PI * n), [1, 0], 1e-11);
  near(motion.at(700), [Math.cos(700), -Math.sin(700)], 1e-11);
});

test("a Kepler orbit of eccentricity 0.6 closes after each of ten periods", () => {
  const rate = ([x, y, u, v]) => {
    const cube = Math.hypot(x, y) ** 3;
    return [u, v, -x / cube, -y / cube];
  };
  const start = [0.4, 0, 0, 2], motion = new Motion(rate, start);
  for (let n = 1; n <= 10; n++) near(motion.at(2 * Math.PI * n), start, 1e-9);
  near(new Motion(rate, start).at(Math.PI), [-1.6, 0, 0, -0.5], 1e-11);
});

test("with a tolerance that never binds the error of a step falls with its length as its order says", () => {
  const error = (H) => {
    const motion = new Motion(([x, v]) => [v, -x], [1, 0], 1e9);
    motion.step = H;
    motion.at(H);
    return Math.hypot(motion.state[0] - Math.cos(H), motion.state[1] + Math.sin(H));
  };
  const order = Math.log2(error(6) / error(3));         // 8 rows: 16, and one more for a step
  assert.ok(order > 15 && order < 19, `${order}`);
});

test("the times that are asked for make no difference", () => {
  const rate = ([x, v]) => [v, -Math.sin(x)], often = new Motion(rate, [3, 0]), once = new Motion(rate, [3, 0]);
  for (let n = 1; n <= 3000; n++) often.at(n / 100);
  near(often.state, once.at(30), 1e-9);
  assert.deepEqual(once.at(30), once.state);            // no time passes
});

test("too long a step is shortened, and a motion that ends is said to", () => {
  const fast = new Motion(([x, v]) => [1e6 * v, -1e6 * x], [1, 0]);
  near(fast.at(1e-3), [Math.cos(1000), -Math.sin(1000)], 1e-9);
  const steep = new Motion(([x]) => [-(x ** 9)], [10]);    // a step of 0.1 leaves the doubles
  near(steep.at(1), [(8 + 1e-8) ** (-1 / 8)], 1e-9);
  assert.throws(() => new Motion(([x]) => [x * x], [1]).at(2), /leaves the numbers/);
});
