// What fingers and a mouse mean: who scrolls sets no number.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Hands } from "../../docs/try/views/chart-hands.js";

const POINT = [100, 100];

function tried(point = POINT) {
  const done = [];
  const hands = new Hands({ point: () => point, within: ([x, y]) => Math.max(x, y) <= 400, set: (place) => done.push(["set", ...place]),
    stretch: (from, to, factor) => done.push(["stretch", from, to, factor]) });
  const pointer = (id, place, more) => ({ id, touch: true, shift: false, place, ...more });
  return { done, hands, press: (id, place, more) => hands.pressed(pointer(id, place, more)),
    move: (id, place, more) => hands.moved(pointer(id, place, more)),
    lift: (id, place, more) => hands.lifted(pointer(id, place, more)) };
}
const MOUSE = { touch: false };

test("a finger that scrolls changes nothing", () => {
  const { done, hands, press, move, lift } = tried();
  press(1, [200, 200]);
  move(1, [200, 215]);
  hands.lost(1);                                        // the page takes it
  press(2, [50, 200]);
  move(2, [50, 230]);
  lift(2, [50, 201]);
  assert.deepEqual(done, []);
});

test("a tap sets the point", () => {
  const { done, press, move, lift } = tried();
  press(1, [200, 200]);
  move(1, [203, 202]);
  assert.deepEqual(done, []);
  lift(1, [203, 202]);
  assert.deepEqual(done, [["set", 203, 202]]);
});

test("a finger near the point drags it from where it is", () => {
  const { done, press, move, lift } = tried();
  press(1, [110, 95]);
  assert.deepEqual(done, []);
  move(1, [120, 95]);
  lift(1, [120, 95]);
  move(1, [300, 300]);
  assert.deepEqual(done, [["set", 110, 100]]);
});

test("what is pressed beside the chart sets nothing", () => {
  const { done, press, move, lift } = tried();
  for (const more of [{}, MOUSE]) {
    press(1, [200, 420], more);
    move(1, [200, 300], more);
    lift(1, [200, 420], more);
  }
  assert.deepEqual(done, []);
});

test("no finger drags a point that is not seen", () => {
  const { done, press, move } = tried(null);
  press(1, [100, 100]);
  move(1, [150, 100]);
  assert.deepEqual(done, []);
});

test("two fingers zoom about their middle and move what is seen", () => {
  const { done, press, move, lift } = tried();
  press(1, [200, 200]);
  press(2, [300, 200]);
  move(2, [400, 200]);
  move(1, [200, 240]);
  assert.deepEqual(done[0], ["stretch", [250, 200], [300, 200], 0.5]);
  assert.equal(done[1][0], "stretch");
  lift(2, [400, 200]);
  move(1, [90, 90]);
  lift(1, [90, 90]);
  assert.equal(done.length, 2);                         // the finger that stays sets nothing
});

test("a mouse sets the point and drags it, with shift it moves what is seen", () => {
  const { done, press, move, lift } = tried();
  press(1, [200, 200], MOUSE);
  move(1, [210, 200], MOUSE);
  lift(1, [210, 200], MOUSE);
  move(1, [250, 200], MOUSE);
  press(1, [200, 200], { ...MOUSE, shift: true });
  move(1, [190, 205], MOUSE);
  assert.deepEqual(done, [["set", 200, 200], ["set", 210, 200], ["stretch", [200, 200], [190, 205], 1]]);
});
