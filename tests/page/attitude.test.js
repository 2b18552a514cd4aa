// Attitudes and motions of a body: Jacobi's rotations, rigid rotations, what is conserved in space.
import assert from "node:assert/strict";
import { test } from "node:test";
import { broughtNear, cross, dot, principal, quaternion, rotation, turned, turning, unit, upright, UNTURNED }
  from "../../docs/try/numerics/attitude.js";
import { attitudeAt, fastest, Flight, followed, momentum, released } from "../../docs/try/numerics/flight.js";
import { Motion } from "../../docs/try/numerics/integrator.js";

/** Numbers between -1 and 1 that are the same each time. */
function drawn(seed) {
  let state = seed;
  return () => {
    state = (1103515245 * state + 12345) % 2147483648;
    return 2 * state / 2147483648 - 1;
  };
}

function near(found, expected, tolerance, what = "") {
  found.flat().forEach((x, n) => assert.ok(Math.abs(x - expected.flat()[n]) <= tolerance, `${what} ${found} for ${expected}`));
}

const transposed = (R) => R[0].map((_, j) => R.map((row) => row[j]));
const times = (A, B) => A.map((row) => transposed(B).map((column) => dot(row, column)));

test("the principal axes of a tensor diagonalise it, right-handed", () => {
  const number = drawn(1);
  for (let n = 0; n < 200; n++) {
    const tensor = [3 + number(), 3 + number(), 3 + number(), number(), number(), number()];
    const [a, b, c, d, e, f] = tensor, { moments, axes } = principal(tensor);
    const diagonal = times(times(axes, [[a, f, e], [f, b, d], [e, d, c]]), transposed(axes));
    near(diagonal, [[moments[0], 0, 0], [0, moments[1], 0], [0, 0, moments[2]]], 1e-13);
    near([dot(cross(axes[0], axes[1]), axes[2])], [1], 1e-13);
  }
});

test("known tensors: a diagonal one as it is, a turned one, one with a double moment", () => {
  assert.deepEqual(principal([3, 1, 2, 0, 0, 0]), { moments: [3, 1, 2], axes: UNTURNED });
  const half = Math.SQRT1_2, { moments, axes } = principal([2, 2, 5, 0, 0, 1]);     // 1 and 3 along the diagonals
  near([...moments].sort(), [1, 3, 5], 1e-14);
  near([Math.abs(dot(axes[moments.indexOf(Math.max(...moments.slice(0, 2)))], [half, half, 0]))], [1], 1e-14);
  near(principal([2, 2, 2, 1, 1, 1]).moments.sort(), [1, 1, 4], 1e-14);
});

test("a quaternion and its rotation are one attitude", () => {
  const number = drawn(2);
  for (let n = 0; n < 100; n++) {
    const q = unit4([number(), number(), number(), number()]), R = rotation(q), again = quaternion(R);
    near(times(R, transposed(R)), UNTURNED, 1e-14);
    near([Math.abs(q.reduce((sum, x, i) => sum + x * again[i], 0))], [1], 1e-14);
  }
  for (const turn of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) near(quaternion(rotation([0, ...turn])), [0, ...turn], 0);
});

const unit4 = (q) => q.map((x) => x / Math.hypot(...q));

test("a constant angular velocity turns the body about it by its angle", () => {
  const omega = [0.3, -1.2, 0.7], rate = Math.hypot(...omega), axis = unit(omega);
  const motion = new Motion((q) => turning(q, omega), [1, 0, 0, 0]);
  for (const time of [0.5, 3, 10]) {
    const R = rotation(motion.at(time)), c = Math.cos(rate * time), s = Math.sin(rate * time), x = [0.2, 0.5, -1];
    const along = dot(axis, x), aside = cross(axis, x);            // Rodrigues
    near(turned(R, x), x.map((entry, i) => c * entry + s * aside[i] + (1 - c) * along * axis[i]), 1e-11);
  }
});

test("the direction that is up points up, a second one sideways, and a third along axis 1", () => {
  const number = drawn(3);
  for (let n = 0; n < 50; n++) {
    const up = [number(), number(), number()];
    near(turned(upright(up), unit(up)), [0, 0, 1], 1e-14);
    const side = unit(cross(up, [number(), number(), number()])), R = upright(up, side);
    near(turned(R, side), [0, 1, 0], 1e-14);
    near(turned(R, cross(side, unit(up))), [1, 0, 0], 1e-14);
  }
  assert.deepEqual(upright([0, 0, 2]), UNTURNED);
});

test("an attitude is brought near to another by a turn about the vertical", () => {
  const number = drawn(4), trace = (A, B) => A.reduce((sum, row, i) => sum + dot(row, B[i]), 0);
  for (let n = 0; n < 50; n++) {
    const [R, other] = [0, 1].map(() => rotation([number(), number(), number(), number()]));
    const found = broughtNear(R, other), best = trace(found, other);
    near(found[2], R[2], 0);
    for (const angle of [-0.3, -1e-3, 1e-3, 0.3, 2]) {
      const [x, y, z] = found, c = Math.cos(angle), s = Math.sin(angle);
      const aside = [x.map((_, i) => c * x[i] - s * y[i]), x.map((_, i) => s * x[i] + c * y[i]), z];
      assert.ok(trace(aside, other) <= best + 1e-12);
    }
  }
});

// Euler's equations with a rotor and a weight, written here anew: π̇ = (π + l) × ω + k × m, ω = π / I.
const MOMENTS = [1, 2, 2.5], ROTOR = [0.2, -0.3, 0.5], WEIGHT = [0.3, -0.4, 1];
const rates = (numbers) => MOMENTS.map((moment, i) => numbers[`pi${i + 1}`] / moment);

function body(heavy) {
  const coordinates = ["pi1", "pi2", "pi3", ...heavy ? ["k1", "k2", "k3"] : []];
  return { coordinates, velocity: rates, rates: (numbers) => {
    const pi = ["pi1", "pi2", "pi3"].map((name) => numbers[name]), omega = rates(numbers);
    const free = cross(pi.map((x, i) => x + ROTOR[i]), omega);
    if (!heavy) return free;
    const k = ["k1", "k2", "k3"].map((name) => numbers[name]), torque = cross(k, WEIGHT);
    return [...free.map((x, i) => x + torque[i]), ...cross(k, omega)];
  } };
}

test("the angular momentum of a free body is constant in space, to 1e-9", () => {
  const start = [0.4, 2, -0.3], flight = new Flight(body(false), {}, start, ROTOR);
  const M = Math.hypot(...momentum(start, ROTOR));
  for (let time = 1; time <= 60; time++) {
    flight.motion.at(time);
    near(turned(flight.attitude, momentum(flight.state, ROTOR)), [0, 0, M], 1e-9);
    near(times(flight.attitude, transposed(flight.attitude)), UNTURNED, 1e-14);
  }
});

test("the vertical of a heavy body stands still in space, to 1e-9", () => {
  const flight = new Flight(body(true), {}, [0.4, 2, -0.3, 0.6, 0, 0.8], ROTOR), { attitude } = flight;
  for (let time = 1; time <= 60; time++) {
    flight.motion.at(time);
    near(turned(flight.attitude, flight.state.slice(3)), [0, 0, 1], 1e-9);
  }
  assert.ok(Math.abs(attitude[0][0] - flight.attitude[0][0]) > 0.01);
});

test("a body starts from the attitude in which it was, as far as its vertical lets it", () => {
  const before = rotation([0.9, 0.1, -0.2, 0.7]), state = [0.4, 2, -0.3, 0.6, 0, 0.8];
  near(new Flight(body(true), {}, state, ROTOR, before).attitude,
    broughtNear(attitudeAt(state, ROTOR), before), 1e-14);
});

test("in orbit the axes of space are t, n and r", () => {
  const n = unit([1, 2, -1]), r = unit(cross(n, [1, 0, 0])), R = attitudeAt([0, 0, 0, ...n, ...r], ROTOR);
  near(R, [cross(n, r), n, r], 1e-14);
});

test("a state is released by turning its directions, or the momentum of a free body", () => {
  near(released([0, 0, 2.4, 0, 0, 1], 0.1), [0, 0, 2.4, 0, -Math.sin(0.1), Math.cos(0.1)], 1e-15);
  near(released([0, 2, 0], 0.1), [0, 2 * Math.cos(0.1), 2 * Math.sin(0.1)], 1e-15);
  const orbit = released([0, 1, 0, 0, 1, 0, 0, 0, 1], 0.1);
  near(orbit.slice(3, 6), [0, Math.cos(0.1), Math.sin(0.1)], 1e-15);
  near([dot(orbit.slice(3, 6), orbit.slice(6))], [0], 1e-15);
});

test("the fastest motion nearby, in whatever units", () => {
  const rate = ([x, v, a, b]) => [v, -9 * x, -2 * b + a * b, 2 * a];
  for (const unitOf of [1, 1e-4, 1e4]) {
    const scaled = ([x, v, a, b]) => {
      const found = rate([x / unitOf, v, a, b]);
      return [found[0] * unitOf, ...found.slice(1)];
    };
    const found = fastest(scaled, [0, 0, 0, 0]);
    assert.ok(found > 2.9 && found < 4, `${found}`);
  }
  assert.equal(fastest(() => [0, 0], [1, 1]), 0);
});

test("the axis of revolution is followed, else the one nearest to the vertical", () => {
  const axes = UNTURNED;
  assert.equal(followed({ moments: [1, 1, 1.6], axes }, [0.9, 0, 0.4]), 2);
  assert.equal(followed({ moments: [1.6, 1, 1], axes }, [0, 1, 0]), 0);
  assert.equal(followed({ moments: [1, 1.2, 1.6], axes }, [0, -1, 0]), 1);
  assert.equal(followed({ moments: [1, 1, 1], axes }, [0, 1, 0]), 1);
});
