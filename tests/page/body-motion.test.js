// The body of a scene at numbers, from what the library gives: its motion, its rest, what is said of it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { dot, turned, unit } from "../../docs/try/numerics/attitude.js";
import { BodyMotion, portrait, VIEW } from "../../docs/try/views/body-motion.js";

const name = (letter) => ["name", letter], number = (x) => ["number", x];

/** A program whose results are names or numbers. */
const entries = (...all) => ({ steps: all.map((entry) => typeof entry === "string" ? name(entry) : number(entry)),
  results: all.map((_, n) => n) });

/** π / I of a body with principal moments A, B, C. */
const velocity = { steps: ["pi1", "pi2", "pi3", "A", "B", "C"].map(name)
  .concat([["divide", 0, 3], ["divide", 1, 4], ["divide", 2, 5]]), results: [6, 7, 8] };

/** Euler's equations of a free body with a rotor (0, 0, l): π̇ = (π + l) × ω. */
const euler = { steps: [...["pi1", "pi2", "pi3", "A", "B", "C", "l"].map(name), ["divide", 0, 3], ["divide", 1, 4],
  ["divide", 2, 5], ["add", 2, 6], ["multiply", 1, 9], ["multiply", 10, 8], ["subtract", 11, 12], ["multiply", 10, 7],
  ["multiply", 0, 9], ["subtract", 14, 15], ["multiply", 0, 8], ["multiply", 1, 7], ["subtract", 17, 18]],
results: [13, 16, 19] };

const FREE = { coordinates: ["pi1", "pi2", "pi3"], inertia: entries("A", "B", "C", 0, 0, 0), rotor: entries(0, 0, "l"),
  state: entries(0, "p", 0), velocity, rates: euler };
const NUMBERS = { A: 1, B: 2, C: 2.5, l: 0, p: 2 };
const near = (a, b, tolerance = 1e-9) => assert.ok(Math.hypot(...a.map((x, n) => x - b[n])) < tolerance, `${a} for ${b}`);

test("the momentum of a free body stands still, and its path lies on the body", () => {
  const moved = new BodyMotion(FREE);
  assert.equal(moved.restart(NUMBERS, 0.1), "");
  near(moved.flight.state, [0, 2 * Math.cos(0.1), 2 * Math.sin(0.1)]);
  for (let n = 0; n < 500; n++) moved.step(1);
  const { path, attitude, frame } = moved.picture("UNSTABLE", VIEW);
  assert.deepEqual(frame, [{ direction: [0, 0, 1], name: "M" }]);
  near(turned(path.axes, path.past.at(-1).at(-1)), [0, 0, 1]);
  assert.equal(path.axes, attitude);
  for (const point of path.past.flat()) {                // where both spheres of energy and momentum meet
    const energy = point[0] ** 2 + point[1] ** 2 / 2 + point[2] ** 2 / 2.5;
    assert.ok(Math.abs(energy - (Math.cos(0.1) ** 2 / 2 + Math.sin(0.1) ** 2 / 2.5)) < 1e-9);
  }
  assert.match(moved.caption(), /^The homogeneous box .* M stands still\. The path is that of M as the body sees it\.$/);
  assert.match(moved.said(), /^t = \d+\.\d{6}: \(pi1, pi2, pi3\) = \(-?\d/);
});

test("what is to come is where the body then comes", () => {
  const moved = new BodyMotion(FREE);
  moved.restart(NUMBERS, 0.1);
  for (let n = 0; n < 50; n++) moved.step(1);
  assert.equal(moved.foresee(() => true), false);         // no time for it
  assert.equal(moved.foresee(() => false), true);
  const [{ point, time }] = moved.ahead.slice(30);
  assert.ok(moved.ahead[0].time > moved.flight.time);
  moved.flight.motion.at(time);
  near(moved.point(moved.flight, moved.flight.motion.state), point, 1e-6);
});

test("the wheel turns in the sense of l, and is none without a rotor", () => {
  const moved = new BodyMotion(FREE), wheels = [];
  for (const l of [0.5, -0.5, 0]) {
    moved.restart({ ...NUMBERS, l }, 0.1);
    const before = moved.wheel;
    for (let n = 0; n < 5; n++) moved.step(1);
    const { rotor } = moved.picture("", VIEW);
    wheels.push(rotor && dot(rotor.axle, [0, 0, 1]) * Math.sign(moved.wheel - before));
  }
  assert.deepEqual(wheels, [1, -1, null]);                // right-handed about l, whichever way that is
});

test("a body that cannot move is drawn at rest, where its equilibrium is", () => {
  const heavy = { coordinates: ["pi1", "pi2", "pi3", "k1", "k2", "k3"], inertia: FREE.inertia, rotor: FREE.rotor, velocity,
    state: entries(0, 0, 0, 0.6, 0, 0.8), why: "no field" };
  const moved = new BodyMotion(heavy);
  assert.equal(moved.restart(NUMBERS, 0.1), "no field");
  const { attitude, path, frame } = moved.picture("STABLE", VIEW);
  near(turned(attitude, [0.6, 0, 0.8]), [0, 0, 1]);
  assert.deepEqual([path.past, path.ahead, frame[0].name, moved.said()], [[[]], [], "k", ""]);
  const every = new BodyMotion({ inertia: FREE.inertia, rotor: FREE.rotor, why: "choose one" });
  assert.equal(every.restart(NUMBERS, 0.1), "choose one");
  assert.deepEqual(every.picture("", VIEW).frame, []);
});

test("without a body nothing is drawn, and a sentence says why", () => {
  for (const [found, why] of [[undefined, /has no answer/], [{ why: "too large" }, /too large/],
    [{ ...FREE, inertia: entries(1, -2, 3, 0, 0, 0) }, /positive moments/]]) {
    const moved = new BodyMotion(found);
    assert.match(moved.restart(NUMBERS, 0.1), why);
    assert.equal(moved.picture("", VIEW), null);
  }
  const nowhere = new BodyMotion({ ...FREE, state: entries(0, 0, 0) });
  assert.match(nowhere.restart(NUMBERS, 0.1), /an equilibrium that exists/);
  assert.ok(nowhere.picture("", VIEW));
});

test("while a slider is dragged the body goes on from the attitude that it has", () => {
  const moved = new BodyMotion(FREE);
  moved.restart(NUMBERS, 0.05);
  for (let n = 0; n < 40; n++) moved.step(1);
  const before = turned(moved.attitude, [1, 0, 0]);
  moved.restart({ ...NUMBERS, p: 2.01 }, 0.05);
  assert.equal(moved.flight.time, 0);
  assert.ok(dot(turned(moved.attitude, [1, 0, 0]), before) > 0.98);
});

test("a portrait is a picture after some frames, with its path", () => {
  const { path, rotor, view, verdict } = portrait(FREE, { ...NUMBERS, l: 1 }, { verdict: "STABLE", frames: 100 });
  assert.equal(path.past.flat().length, 102);              // the start, the frames, and a corner of two pieces
  assert.equal(path.ahead.length, 61);
  assert.deepEqual([rotor.axle, view, verdict], [unit([0, 0, 1]), VIEW, "STABLE"]);
});
