// Attitudes: R takes a vector from the axes of the body to those of space; a quaternion has its scalar first.

/** @typedef {[number, number, number]} Vector */
/** @typedef {[Vector, Vector, Vector]} Matrix its rows */

/** @param {(n: number) => number} entry @returns {Vector} */
export const vector = (entry) => [entry(0), entry(1), entry(2)];

/** @param {number[]} a @param {number[]} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {number[]} a @param {number[]} b */
export const cross = (a, b) => vector((n) => {
  const next = (n + 1) % 3, last = (n + 2) % 3;
  return a[next] * b[last] - a[last] * b[next];
});

/** @param {number[]} a */
export function unit(a) {
  const length = Math.hypot(...a);
  return vector((n) => a[n] / length);
}

/** @param {Matrix} R @param {number[]} x @returns {Vector} R x */
export const turned = (R, x) => [dot(R[0], x), dot(R[1], x), dot(R[2], x)];

/** @param {Matrix} rows @param {number[]} x the sum of the rows, each x times */
export const combined = (rows, x) => vector((n) => x[0] * rows[0][n] + x[1] * rows[1][n] + x[2] * rows[2][n]);

/** @type {Matrix} */
export const UNTURNED = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/**
 * The attitude in which a direction of the body points up, and another one, if there is one, along axis 2 of
 * space; else axis 1 of the body, or axis 2, stays as near to axis 1 of space as it can.
 * @param {number[]} up
 * @param {number[]} [side] across up
 * @returns {Matrix}
 */
export function upright(up, side) {
  const z = unit(up), near = Math.abs(z[0]) < 0.9 ? UNTURNED[0] : UNTURNED[1], along = dot(near, z);
  const x = unit(side ? cross(side, z) : vector((n) => near[n] - along * z[n]));
  return [x, cross(z, x), z];
}

/**
 * The attitude turned about the vertical of space until it is as near as can be to another one.
 * @param {Matrix} R
 * @param {Matrix} other
 * @returns {Matrix}
 */
export function broughtNear([x, y, z], [u, v]) {
  const angle = Math.atan2(dot(x, v) - dot(y, u), dot(x, u) + dot(y, v));
  const c = Math.cos(angle), s = Math.sin(angle);
  return [vector((n) => c * x[n] - s * y[n]), vector((n) => s * x[n] + c * y[n]), z];
}

/** @param {Matrix} R @returns {number[]} one of its two quaternions */
export function quaternion([[a, b, c], [d, e, f], [g, h, i]]) {
  const rows = [[1 + a + e + i, h - f, c - g, d - b], [h - f, 1 + a - e - i, b + d, c + g],
    [c - g, b + d, 1 - a + e - i, f + h], [d - b, c + g, f + h, 1 - a - e + i]];
  // each row is 4 qₙ q; that of the largest qₙ is the farthest from 0
  const squares = rows.map((row, n) => row[n]), row = rows[squares.indexOf(Math.max(...squares))];
  return row.map((entry) => entry / Math.hypot(...row));
}

/** @param {number[]} q of any length but 0 @returns {Matrix} */
export function rotation([w, x, y, z]) {
  const n = 2 / (w * w + x * x + y * y + z * z);
  return [[1 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)],
    [n * (x * y + w * z), 1 - n * (x * x + z * z), n * (y * z - w * x)],
    [n * (x * z - w * y), n * (y * z + w * x), 1 - n * (x * x + y * y)]];
}

/**
 * The rate of a quaternion, q ω / 2.
 * @param {number[]} q
 * @param {number[]} omega in the axes of the body
 */
export const turning = ([w, x, y, z], [a, b, c]) => [(-x * a - y * b - z * c) / 2,
  (w * a + y * c - z * b) / 2, (w * b + z * a - x * c) / 2, (w * c + x * b - y * a) / 2];

/**
 * The principal moments of a tensor and its principal axes, right-handed, by Jacobi's rotations; those of a
 * diagonal tensor are its entries and the axes as they are.
 * @param {number[]} tensor I11, I22, I33, I23, I31, I12
 * @returns {{ moments: Vector, axes: Matrix }} each axis in the axes of the body
 */
export function principal([I11, I22, I33, I23, I31, I12]) {
  const A = [[I11, I12, I31], [I12, I22, I23], [I31, I23, I33]];
  /** @type {Matrix} */
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const small = 1e-15 * Math.hypot(...A.flat());
  for (let sweep = 0; sweep < 20 && Math.hypot(A[0][1], A[0][2], A[1][2]) > small; sweep++) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (A[p][q] === 0) continue;
      const theta = (A[q][q] - A[p][p]) / (2 * A[p][q]);
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(1, theta));
      const c = 1 / Math.hypot(1, t), s = t * c;
      for (const row of A) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
      for (const rows of [A, axes]) {
        for (let n = 0; n < 3; n++) {
          [rows[p][n], rows[q][n]] = [c * rows[p][n] - s * rows[q][n], s * rows[p][n] + c * rows[q][n]];
        }
      }
    }
  }
  return { moments: vector((n) => A[n][n]), axes };
}
