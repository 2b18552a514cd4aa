// What is painted: the calls of a context, each vertex against a projection written here anew.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { principal, rotation, turned, unit, UNTURNED } from "../../docs/try/numerics/attitude.js";
import { paint } from "../../docs/try/views/body-picture.js";
import { DARK, LIGHT } from "../../docs/try/views/colours.js";
import { solid } from "../../docs/try/views/solids.js";

const ALLOWED = ["moveTo", "lineTo", "arc", "closePath", "beginPath", "stroke", "fill", "fillText", "setLineDash", "save",
  "restore"];
const SET = ["globalAlpha", "lineWidth", "strokeStyle", "fillStyle", "font", "textAlign", "textBaseline"];
const SIZE = 400;

/** A context that keeps what is drawn: polygons that are filled, lines, names. */
function recorder() {
  const drawn = { filled: [], stroked: [], texts: [], dashes: [] };
  let points = [], dash = [];
  const state = { globalAlpha: 1 };
  const calls = {
    beginPath: () => { points = []; },
    moveTo: (x, y) => points.push(["move", x, y]),
    lineTo: (x, y) => points.push(["line", x, y]),
    arc: (x, y, radius) => points.push(["arc", x, y, radius]),
    closePath: () => points.push(["close"]),
    fill: () => drawn.filled.push({ points, ...state }),
    stroke: () => drawn.stroked.push({ points, dash, ...state }),
    fillText: (text, x, y) => drawn.texts.push({ text, x, y }),
    setLineDash: (given) => { dash = given; },
  };
  const context = new Proxy(calls, {
    get(_, name) {
      assert.ok(ALLOWED.includes(name), `${String(name)} is called`);
      return calls[name];
    },
    set(_, name, value) {
      assert.ok(SET.includes(name), `${String(name)} is set`);
      state[name] = value;
      return true;
    },
  });
  return { context, drawn };
}

function picture(moments, more = {}) {
  return { solid: solid(moments), axes: UNTURNED, attitude: UNTURNED, rotor: null, frame: [], verdict: "", view: [0.6, 0.4],
    path: { axes: UNTURNED, past: [], age: [], ahead: [] }, ...more };
}

function painted(given, colours = LIGHT) {
  const { context, drawn } = recorder();
  paint(context, SIZE, given, colours);
  return drawn;
}

/** The eye turned about the vertical, then raised, by two rotations in a row, and a perspective from 7. */
function place([x, y, z], [turn, tilt]) {
  const a = Math.cos(turn) * x - Math.sin(turn) * y, b = Math.sin(turn) * x + Math.cos(turn) * y;
  const up = Math.cos(tilt) * z + Math.sin(tilt) * b, away = Math.cos(tilt) * b - Math.sin(tilt) * z;
  const unitLength = 0.36 * SIZE * 7 / (7 + away);
  return [0.5 * SIZE + unitLength * a, 0.53 * SIZE - unitLength * up, away];
}

const corners = ({ points }) => points.filter(([kind]) => kind === "move" || kind === "line").map(([, x, y]) => [x, y]);
const close = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < 1e-9;

test("each face of the box that is turned to the eye is painted where its corners are, and no other", () => {
  const attitude = rotation([0.9, 0.1, -0.2, 0.3]), view = [0.6, 0.4], given = picture([1, 2, 2.5], { attitude, view });
  const [a, b, c] = given.solid.half, found = painted(given).filled.filter(({ points }) => corners({ points }).length === 4);
  assert.equal(found.length, 3);
  const all = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => place(turned(attitude, [x * a, y * b, z * c]), view))));
  const seen = Array(8).fill(0);
  for (const face of found) {
    for (const corner of corners(face)) {
      const which = all.findIndex((place) => close(place, corner));
      assert.ok(which >= 0);
      seen[which] += 1;
    }
  }
  const depths = all.map(([, , away]) => away);
  assert.equal(seen[depths.indexOf(Math.min(...depths))], 3);    // the nearest corner is one of all three
  assert.equal(seen[depths.indexOf(Math.max(...depths))], 0);    // and the farthest is hidden
});

test("a tensor with products of inertia is drawn by its principal axes", () => {
  const half = Math.SQRT1_2, body = principal([2, 2, 2.5, 0, 0, 0.5]), given = picture(body.moments, body);
  const names = painted(given).texts.map(({ text }) => text);
  assert.ok(names.includes("e₁") && names.includes("e₃"));
  const tips = painted(given).stroked.map((stroke) => corners(stroke).at(-1)).filter(Boolean);
  for (const axis of [[half, half, 0], [half, -half, 0]]) {
    assert.ok(tips.some((tip) => close(tip, place(axis, given.view)) || close(tip, place(axis.map((x) => -x), given.view))));
  }
});

test("an axis that leaves the body behind is painted before its faces", () => {
  for (const [view, first] of [[[0, 0], true], [[Math.PI, 0], false]]) {
    const attitude = rotation([1, 0.1, 0, 0]), tip = place(turned(attitude, [0, 1, 0]), view);
    const order = [], { context } = recorder(), recording = new Proxy(context, {
      get: (target, name) => (...given) => {
        if (name === "lineTo" && close(given, tip)) order.push("axis");
        if (name === "fill") order.push("fill");
        return target[name](...given);
      },
      set: (target, name, value) => Reflect.set(target, name, value) });
    paint(recording, SIZE, picture([1, 1, 1], { view, attitude }), LIGHT);
    const axis = order.indexOf("axis"), before = order.slice(0, axis).filter((what) => what === "fill").length;
    assert.equal(before < 3, first);             // axis 2 points away from the eye that is not turned
  }
});

test("a name that is behind the body is not painted", () => {
  const texts = (view) => painted(picture([1, 1, 1], { view })).texts.map(({ text }) => text);
  assert.deepEqual(texts([0, 0]), ["e₁", "e₃"]);
  assert.deepEqual(texts([Math.PI, 0.1]), ["e₁", "e₂", "e₃"]);
});

test("the path has the colour and the line of the verdict", () => {
  const points = Array.from({ length: 20 }, (_, n) => unit([Math.cos(n / 20), Math.sin(n / 20), 0.5]));
  const lines = {};
  for (const colours of [LIGHT, DARK]) {
    for (const verdict of ["STABLE", "UNSTABLE", "UNDECIDED", ""]) {
      const given = picture([1, 1, 1.6], { verdict, path: { axes: UNTURNED, past: [points], age: [0], ahead: [] } });
      const found = painted(given, colours).stroked.filter((stroke) => stroke.lineWidth === 2 && stroke.points.length);
      const expected = points.map((point) => place(point, given.view));
      assert.ok(found.length && found.every(({ strokeStyle }) => strokeStyle === colours.verdicts[verdict]));
      assert.ok(found.flatMap(corners).every((corner) => expected.some((there) => close(there, corner))));
      assert.ok(expected.every((there) => found.flatMap(corners).some((corner) => close(there, corner))));
      lines[verdict] = found[0].dash;
    }
  }
  assert.deepEqual(lines.STABLE, []);
  assert.ok(lines.UNSTABLE[0] > lines.UNDECIDED[0] && lines.UNDECIDED[0] > 0);
});

test("a path that the body carries turns with it, and what is old is pale", () => {
  const attitude = rotation([0.8, 0.3, -0.4, 0.2]), points = [[0, 0, 1], [0, 0.1, 1], [0, 0.2, 1]].map(unit);
  const given = picture([1, 1, 1.6], { attitude, path: { axes: attitude, past: [points, points.toReversed()], age: [0.9, 0],
    ahead: [] } });
  const found = painted(given).stroked.filter((stroke) => stroke.lineWidth === 2 && stroke.points.length === 3);
  assert.ok(found.some((stroke) => close(corners(stroke)[1], place(turned(attitude, points[1]), given.view))));
  assert.ok(found[0].globalAlpha < found[1].globalAlpha);
});

test("a wheel is painted for a rotor, and turns", () => {
  const still = painted(picture([1, 1, 1.6])).filled.length;
  const [one, other] = [0, 0.4].map((angle) => painted(picture([1, 1, 1.6], { rotor: { axle: [0, 0, 1], angle } })));
  assert.ok(one.filled.length > still + 10);
  assert.notDeepEqual(one.filled.map(corners), other.filled.map(corners));
  assert.ok(one.texts.some(({ text }) => text === "l"));
});

test("bodies of degenerate and of impossible moments are painted in finite numbers", () => {
  for (const moments of [[1, 2, 3], [1, 1, 5], [1e-9, 1, 1], [1, 1, 1]]) {
    for (const axle of [[0, 0, 1], [1, 0, 0], unit([1, 1, 1])]) {
      for (const view of [[0, 0], [0.6, 0.4], [1, 1.5]]) {
        const drawn = painted(picture(moments, { rotor: { axle, angle: 1 }, view }));
        const numbers = [...drawn.filled, ...drawn.stroked].flatMap(({ points }) => points.flatMap(([, ...rest]) => rest));
        assert.ok(numbers.length && numbers.every(Number.isFinite));
        assert.ok(drawn.filled.every(({ fillStyle }) => !fillStyle.includes("NaN")));
      }
    }
  }
});

test("the colours of the verdicts are those of the page", () => {
  const css = readFileSync(new URL("../../docs/try/try.css", import.meta.url), "utf-8");
  for (const name of ["stable", "unstable", "undecided"]) {
    const [, light, dark] = css.match(new RegExp(`--${name}: light-dark\\((#\\w+), (#\\w+)\\)`));
    assert.deepEqual([LIGHT, DARK].map(({ verdicts }) => verdicts[name.toUpperCase()]), [light, dark]);
  }
});
