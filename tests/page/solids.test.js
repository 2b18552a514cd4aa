// The solids that stand for a body, and its wheel.
import assert from "node:assert/strict";
import { test } from "node:test";
import { cross, dot, unit } from "../../docs/try/numerics/attitude.js";
import { exit, solid, wheel } from "../../docs/try/views/solids.js";

/** The second moments of a solid about its centre, summed over the cones that lead to its faces: ∫ x xᵀ. */
function secondMoments(faces) {
  const sums = [[0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (const { corners } of faces) {
    for (let n = 1; n + 1 < corners.length; n++) {
      const three = [corners[0], corners[n], corners[n + 1]], volume = dot(three[0], cross(three[1], three[2])) / 6;
      const whole = [0, 1, 2].map((i) => three.reduce((sum, corner) => sum + corner[i], 0));
      for (let i = 0; i < 3; i++) {
        for (let j = 0; j < 3; j++) {            // of a tetrahedron: V/20 (Σ x xᵀ + Σx Σxᵀ), one corner at the centre
          sums[i][j] += volume / 20 * (three.reduce((sum, corner) => sum + corner[i] * corner[j], 0) + whole[i] * whole[j]);
        }
      }
    }
  }
  return sums;
}

test("the box has the given moments, up to one factor", () => {
  for (const moments of [[1, 1, 1], [1, 1, 1.6], [1, 2, 2.5], [0.002, 0.0021, 0.0015], [120, 58, 62.1]]) {
    const { kind, faces } = solid(moments), [[xx, xy, xz], [, yy, yz], [, , zz]] = secondMoments(faces);
    assert.equal(kind, "box");
    const found = [yy + zz, zz + xx, xx + yy];
    for (const product of [xy, xz, yz]) assert.ok(Math.abs(product) < 1e-15);
    for (const n of [1, 2]) {
      assert.ok(Math.abs(found[n] / found[0] - moments[n] / moments[0]) < 1e-12 * moments[n] / moments[0]);
    }
  }
});

test("faces are seen from outside counterclockwise, and none is farther than axes are long", () => {
  for (const moments of [[1, 1, 1.6], [1, 1, 5], [3, 1, 2]]) {
    for (const { corners: [a, b, c] } of solid(moments).faces) {
      const out = cross(b.map((x, n) => x - a[n]), c.map((x, n) => x - a[n]));
      assert.ok(dot(out, a) >= 0 && Math.hypot(...a) < 0.8);
    }
  }
});

test("a lamina has no thickness, and rounding does not give it one", () => {
  for (const moments of [[1, 2, 3], [0.3, 0.6, 0.9], [1 / 3, 2 / 3, 1]]) {
    const { kind, half } = solid(moments);
    assert.equal(kind, "box");
    assert.equal(half[2], 0);
    assert.ok(half[0] > 0 && half[1] > 0);
  }
  assert.equal(exit(solid([1, 2, 3]), [0, 0, 1]).reach, 0);
});

test("moments of no body have the ellipsoid of inertia", () => {
  const moments = [1, 1, 5], { kind, half, faces } = solid(moments);
  assert.equal(kind, "ellipsoid");
  for (const { corners } of faces) {
    for (const corner of corners) {
      const level = moments.reduce((sum, moment, n) => sum + moment * corner[n] ** 2, 0);
      assert.ok(Math.abs(level - half[0] ** 2) < 1e-12);
    }
  }
});

test("a ray leaves a solid at its surface, across which its normal is", () => {
  const box = solid([1, 2, 2.5]), direction = unit([0.3, -0.9, 0.5]), { reach, normal } = exit(box, direction);
  const shares = direction.map((x, n) => Math.abs(x * reach) / box.half[n]);
  assert.ok(Math.abs(Math.max(...shares) - 1) < 1e-15);
  assert.deepEqual(normal.map((x) => x + 0), [0, -1, 0]);
  const round = solid([1, 1, 5]), there = exit(round, direction);
  const place = direction.map((x, n) => x * there.reach / round.half[n]);
  assert.ok(Math.abs(Math.hypot(...place) - 1) < 1e-15);
  assert.ok(cross(unit(there.normal), unit(place.map((x, n) => x / round.half[n]))).every((x) => Math.abs(x) < 1e-15));
});

test("the wheel lies across its axle, in the body where it has room, and turns right-handed about it", () => {
  for (const [moments, axle] of [[[1, 1, 1.6], [0, 0, 1]], [[1, 2, 2.5], unit([1, 2, -2])], [[1, 1, 5], [0, -1, 0]]]) {
    const body = solid(moments), faces = wheel(body, axle, 0.3), later = wheel(body, axle, 0.31);
    const thick = Math.max(...faces.flatMap(({ corners }) => corners.map((corner) => dot(corner, axle))));
    assert.ok(thick < 0.1);
    faces.forEach(({ corners }, f) => corners.forEach((corner, n) => {
      const moved = later[f].corners[n].map((x, i) => x - corner[i]), turn = dot(cross(corner, moved), axle);
      const radius = Math.hypot(...cross(axle, corner));
      assert.ok(Math.abs(turn - radius * radius * Math.sin(0.01)) < 1e-12);
      if (body.kind === "box") corner.forEach((x, i) => assert.ok(Math.abs(x) <= body.half[i] + thick));
    }));
  }
  assert.equal(wheel(solid([1, 2, 3]), [1, 0, 0], 0).every(({ corners }) => corners.flat().every(Number.isFinite)), true);
});
