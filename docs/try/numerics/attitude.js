// Attitudes: R takes the axes of the body to those of space, x_space = R x_body; its quaternion has the scalar first.

/** @typedef {[number, number, number]} Vector */
/** @typedef {[Vector, Vector, Vector]} Matrix its rows */

/** @param {number[]} a @param {number[]} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {number[]} a @param {number[]} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {number[]} a @returns {Vector} */
export function unit(a) {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

/** @param {Matrix} R @param {number[]} x @returns {Vector} */
export const turned = (R, x) => [dot(R[0], x), dot(R[1], x), dot(R[2], x)];

/** @type {Matrix} */
export const UNTURNED = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/**
 * The attitude in which a direction of the body points up in space and another one, if there is one, sideways along
 * axis 2 of space; else axis 1 of the body, or axis 2, turns as little as it can.
 * @param {number[]} up
 * @param {number[]} [side] across up
 * @returns {Matrix}
 */
export function upright(up, side) {
  const z = unit(up), near = Math.abs(z[0]) < 0.9 ? UNTURNED[0] : UNTURNED[1], along = dot(near, z);
  const x = side ? unit(cross(side, z)) : unit(near.map((entry, i) => entry - along * z[i]));
  return [x, cross(z, x), z];
}

/**
 * The attitude turned about the vertical of space until it is as near as can be to another one.
 * @param {Matrix} R
 * @param {Matrix} other
 * @returns {Matrix}
 */
export function broughtNear(R, other) {
  const angle = Math.atan2(dot(R[0], other[1]) - dot(R[1], other[0]), dot(R[0], other[0]) + dot(R[1], other[1]));
  const c = Math.cos(angle), s = Math.sin(angle), [x, y, z] = R;
  return [[0, 1, 2].map((i) => c * x[i] - s * y[i]), [0, 1, 2].map((i) => s * x[i] + c * y[i]), z];
}

/** @param {Matrix} R @returns {number[]} one of its two quaternions */
export function quaternion(R) {
  const [[a, b, c], [d, e, f], [g, h, i]] = R;
  // the largest of the four entries first, so that nothing small is divided by
  const rows = [[1 + a + e + i, h - f, c - g, d - b], [h - f, 1 + a - e - i, b + d, c + g],
    [c - g, b + d, 1 - a + e - i, f + h], [d - b, c + g, f + h, 1 - a - e + i]];
  const largest = rows.map((row, n) => row[n]), row = rows[largest.indexOf(Math.max(...largest))];
  const length = Math.hypot(...row);
  return row.map((entry) => entry / length);
}

/** @param {number[]} q of any length but 0 @returns {Matrix} */
export function rotation([w, x, y, z]) {
  const n = 2 / (w * w + x * x + y * y + z * z);
  return [[1 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)],
    [n * (x * y + w * z), 1 - n * (x * x + z * z), n * (y * z - w * x)],
    [n * (x * z - w * y), n * (y * z + w * x), 1 - n * (x * x + y * y)]];
}

/**
 * The rate of a quaternion, half of q ω, where ω has the axes of the body.
 * @param {number[]} q
 * @param {number[]} omega
 */
export const turning = ([w, x, y, z], [a, b, c]) => [(-x * a - y * b - z * c) / 2, (w * a + y * c - z * b) / 2,
  (w * b + z * a - x * c) / 2, (w * c + x * b - y * a) / 2];

/**
 * The principal moments of a tensor and its principal axes, right-handed, by Jacobi's rotations; of a diagonal tensor
 * its entries and the axes as they are.
 * @param {number[]} tensor I11, I22, I33, I23, I31, I12
 * @returns {{ moments: Vector, axes: Matrix }} each axis in the axes of the body
 */
export function principal([I11, I22, I33, I23, I31, I12]) {
  const A = [[I11, I12, I31], [I12, I22, I23], [I31, I23, I33]], axes = UNTURNED.map((row) => [...row]);
  const small = 1e-15 * Math.hypot(...A.flat());
  for (let sweep = 0; sweep < 20 && Math.hypot(A[0][1], A[0][2], A[1][2]) > small; sweep++) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (A[p][q] === 0) continue;
      const theta = (A[q][q] - A[p][p]) / (2 * A[p][q]);
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(1, theta)), c = 1 / Math.hypot(1, t), s = t * c;
      for (const row of A) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
      for (let n = 0; n < 3; n++) {
        [A[p][n], A[q][n]] = [c * A[p][n] - s * A[q][n], s * A[p][n] + c * A[q][n]];
        [axes[p][n], axes[q][n]] = [c * axes[p][n] - s * axes[q][n], s * axes[p][n] + c * axes[q][n]];
      }
    }
  }
  return { moments: [A[0][0], A[1][1], A[2][2]], axes: /** @type {Matrix} */ (axes) };
}
