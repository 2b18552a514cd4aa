// Solids that stand for a body, in its principal axes; faces are flat, their corners counterclockwise outside.
import { combined, cross, unit, UNTURNED, vector } from "../numerics/attitude.js";

/** @typedef {import("../numerics/attitude.js").Vector} Vector */

/**
 * @typedef {object} Face
 * @property {Vector[]} corners
 * @property {number} tone the place of its colour among those of the body, or of the wheel
 */

/**
 * @typedef {object} Solid
 * @property {"box" | "ellipsoid"} kind
 * @property {Vector} half half of its length along each axis
 * @property {Face[]} faces
 */

const REACH = 0.68;                                     // of the farthest corner; the axes have the length 1
const ROUND = 1e-12;                                    // what rounding leaves of the thickness of a lamina
const RINGS = 10, SECTORS = 24, SLICES = 6;
const ACCENT = 3;                                       // the face at the end of axis 3 stands out

/**
 * The homogeneous box with these principal moments: I1 is proportional to b² + c² of its edges, and so on. No
 * body has a moment larger than the sum of the others; then the ellipsoid of inertia, I1 x² + I2 y² + I3 z² = 1.
 * @param {number[]} moments positive
 * @returns {Solid}
 */
export function solid(moments) {
  const sum = moments[0] + moments[1] + moments[2];
  const squares = moments.map((moment) => sum - 2 * moment).map((x) => Math.abs(x) < ROUND * sum ? 0 : x);
  if (squares.every((x) => x >= 0)) {
    const edges = squares.map(Math.sqrt), factor = REACH / Math.hypot(...edges);
    const half = vector((n) => factor * edges[n]);
    return { kind: "box", half, faces: box(half) };
  }
  const least = Math.min(...moments), half = vector((n) => REACH * Math.sqrt(least / moments[n]));
  return { kind: "ellipsoid", half, faces: ellipsoid(half) };
}

/** @param {Vector} half @returns {Face[]} */
function box(half) {
  return [0, 1, 2].flatMap((axis) => [1, -1].map((side) => {
    const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) =>
      vector((n) => half[n] * (n === axis ? side : n === (axis + 1) % 3 ? a : side * b)));
    return { corners, tone: axis === 2 && side === 1 ? ACCENT : axis };
  }));
}

/** @param {Vector} half @returns {Face[]} octants by turns in two colours, which show how it turns */
function ellipsoid(half) {
  /** @param {number} ring @param {number} sector */
  const point = (ring, sector) => {
    const down = Math.PI * ring / RINGS, round = 2 * Math.PI * sector / SECTORS;
    const [x, y, z] = [Math.sin(down) * Math.cos(round), Math.sin(down) * Math.sin(round), Math.cos(down)];
    return vector((n) => half[n] * [x, y, z][n]);
  };
  return Array.from({ length: RINGS * SECTORS }, (_, n) => {
    const ring = Math.floor(n / SECTORS), sector = n % SECTORS, low = ring < RINGS / 2 ? 0 : 1;
    const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([down, on]) => point(ring + down, sector + on));
    const tone = ring ? (Math.floor(4 * sector / SECTORS) + low) % 2 : ACCENT;
    return { corners: ring ? corners : corners.slice(0, 3), tone };
  });
}

/**
 * Where a ray from its centre leaves a solid, and what is across its surface there.
 * @param {Solid} solid
 * @param {number[]} direction a unit vector
 */
export function exit({ kind, half }, direction) {
  const shares = vector((n) => direction[n] && direction[n] / half[n]), sizes = shares.map(Math.abs);
  const most = Math.max(...sizes), face = sizes.indexOf(most);
  return kind === "box" ? { reach: 1 / most, normal: vector((n) => n === face ? Math.sign(direction[n]) : 0) }
    : { reach: 1 / Math.hypot(...shares), normal: vector((n) => shares[n] / half[n]) };
}

/**
 * A wheel about a direction, inside a solid if it has room there.
 * @param {Solid} solid
 * @param {Vector} axle a unit vector
 * @param {number} angle by which it is turned, right-handed
 * @returns {Face[]}
 */
export function wheel({ half }, axle, angle) {
  const room = half.map((length, n) => length / Math.sqrt(Math.max(1 - axle[n] ** 2, 1e-12)));
  const radius = Math.min(0.5, Math.max(0.8 * Math.min(...room), 0.2)), thick = 0.14 * radius;
  const quiet = axle.map(Math.abs), x = unit(cross(UNTURNED[quiet.indexOf(Math.min(...quiet))], axle));
  /** @param {number} sector @param {number} side @param {number} r */
  const point = (sector, side, r) => {
    const round = angle + 2 * Math.PI * sector / SECTORS;
    return combined([x, cross(axle, x), axle], [r * Math.cos(round), r * Math.sin(round), side]);
  };
  const wide = SECTORS / SLICES;
  return Array.from({ length: SLICES }, (_, slice) => {
    const rim = Array.from({ length: wide + 1 }, (__, n) => slice * wide + n);
    const caps = [thick, -thick].map((side) => [point(0, side, 0),
      ...(side > 0 ? rim : rim.toReversed()).map((sector) => point(sector, side, radius))]);
    const band = rim.slice(0, wide).map((sector) => [[0, -1], [1, -1], [1, 1], [0, 1]].map(([on, side]) =>
      point(sector + on, side * thick, radius)));
    return [...caps, ...band].map((corners) => ({ corners, tone: slice % 2 }));
  }).flat();
}
