// Solids that stand for a body, in its principal axes: flat faces, seen from outside counterclockwise.

/** @typedef {import("../numerics/attitude.js").Vector} Vector */

/**
 * @typedef {object} Face
 * @property {Vector[]} corners
 * @property {number} tone the place of its colour in those of a body or of a wheel
 */

/**
 * @typedef {object} Solid
 * @property {"box" | "ellipsoid"} kind
 * @property {Vector} half half of its length along each axis
 * @property {Face[]} faces
 */

const REACH = 0.68;                                     // of the farthest point, where axes have the length 1
const ROUND = 1e-12;                                    // what rounding leaves of a lamina
const RINGS = 10, SECTORS = 24, SLICES = 6;
const ACCENT = 3;                                       // the face at the end of axis 3 has a colour of its own

/**
 * The homogeneous box with these principal moments, 12 I1 = m (b² + c²) of its edges, and so on. No body has moments of
 * which one exceeds the sum of the others; then the ellipsoid of inertia, I1 x² + I2 y² + I3 z² = 1.
 * @param {number[]} moments positive
 * @returns {Solid}
 */
export function solid(moments) {
  const sum = moments[0] + moments[1] + moments[2];
  const squares = moments.map((moment) => sum - 2 * moment).map((x) => Math.abs(x) < ROUND * sum ? 0 : x);
  if (squares.some((x) => x < 0)) {
    const half = scaled(moments.map((moment) => 1 / Math.sqrt(moment)), Math.max);
    return { kind: "ellipsoid", half, faces: ellipsoid(half) };
  }
  const half = scaled(squares.map(Math.sqrt), Math.hypot);
  return { kind: "box", half, faces: box(half) };
}

/** @param {number[]} lengths @param {(...lengths: number[]) => number} size @returns {Vector} */
function scaled(lengths, size) {
  const factor = REACH / size(...lengths);
  return [lengths[0] * factor, lengths[1] * factor, lengths[2] * factor];
}

/** @param {Vector} half @returns {Face[]} */
function box(half) {
  /** @type {Face[]} */
  const faces = [];
  for (const axis of [0, 1, 2]) {
    for (const side of [1, -1]) {
      const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([a, b]) => {
        const corner = /** @type {Vector} */ ([0, 0, 0]);
        corner[axis] = side * half[axis];
        corner[(axis + 1) % 3] = a * half[(axis + 1) % 3];
        corner[(axis + 2) % 3] = side * b * half[(axis + 2) % 3];
        return corner;
      });
      faces.push({ corners, tone: axis === 2 && side === 1 ? ACCENT : axis });
    }
  }
  return faces;
}

/** @param {Vector} half @returns {Face[]} octants in two colours, which show how it turns */
function ellipsoid([a, b, c]) {
  /** @type {(ring: number, sector: number) => Vector} */
  const point = (ring, sector) => {
    const down = Math.PI * ring / RINGS, round = 2 * Math.PI * sector / SECTORS;
    return [a * Math.sin(down) * Math.cos(round), b * Math.sin(down) * Math.sin(round), c * Math.cos(down)];
  };
  /** @type {Face[]} */
  const faces = [];
  for (let ring = 0; ring < RINGS; ring++) {
    for (let sector = 0; sector < SECTORS; sector++) {
      const corners = [point(ring, sector), point(ring + 1, sector), point(ring + 1, sector + 1), point(ring, sector + 1)];
      const octant = Math.floor(4 * sector / SECTORS) + (ring < RINGS / 2 ? 0 : 1);
      faces.push({ corners: ring === 0 ? corners.slice(0, 3) : corners, tone: ring === 0 ? ACCENT : octant % 2 });
    }
  }
  return faces;
}

/**
 * Where a ray from its centre leaves a solid.
 * @param {Solid} solid
 * @param {number[]} direction a unit vector in its axes
 * @returns {{ reach: number, normal: Vector }} the distance, and what is across the surface there
 */
export function exit({ kind, half }, direction) {
  const shares = direction.map((x, n) => x === 0 ? 0 : x / half[n]), sizes = shares.map(Math.abs);
  const most = Math.max(...sizes), face = sizes.indexOf(most);
  /** @type {(entry: (n: number) => number) => Vector} */
  const vector = (entry) => [entry(0), entry(1), entry(2)];
  if (kind === "box") return { reach: 1 / most, normal: vector((n) => n === face ? Math.sign(direction[n]) : 0) };
  return { reach: 1 / Math.hypot(...shares), normal: vector((n) => shares[n] / half[n]) };
}

/**
 * A wheel about a direction, inside a solid where it has room, turned by an angle.
 * @param {Solid} solid
 * @param {Vector} axle a unit vector in its axes
 * @param {number} angle right-handed about the axle
 * @returns {Face[]}
 */
export function wheel({ half }, axle, angle) {
  const room = half.map((length, n) => length / Math.sqrt(Math.max(1 - axle[n] ** 2, 1e-12)));
  const radius = Math.min(0.5, Math.max(0.8 * Math.min(...room), 0.2)), thick = 0.14 * radius;
  const quiet = axle.map(Math.abs), least = quiet.indexOf(Math.min(...quiet));
  const across = [0, 1, 2].map((n) => (n === least ? 1 : 0) - axle[least] * axle[n]), long = Math.hypot(...across);
  const x = across.map((entry) => entry / long);
  const y = [axle[1] * x[2] - axle[2] * x[1], axle[2] * x[0] - axle[0] * x[2], axle[0] * x[1] - axle[1] * x[0]];
  /** @type {(sector: number, side: number, r: number) => Vector} */
  const point = (sector, side, r) => {
    const round = angle + 2 * Math.PI * sector / SECTORS, c = r * Math.cos(round), s = r * Math.sin(round);
    return [c * x[0] + s * y[0] + side * axle[0], c * x[1] + s * y[1] + side * axle[1],
      c * x[2] + s * y[2] + side * axle[2]];
  };
  /** @type {Face[]} */
  const faces = [], wide = SECTORS / SLICES;
  for (let slice = 0; slice < SLICES; slice++) {
    const rim = Array.from({ length: wide + 1 }, (_, n) => slice * wide + n);
    for (const side of [thick, -thick]) {
      const order = side > 0 ? rim : rim.toReversed();
      faces.push({ corners: [point(0, side, 0), ...order.map((sector) => point(sector, side, radius))], tone: slice % 2 });
    }
    for (const sector of rim.slice(0, wide)) {
      faces.push({ corners: [point(sector, -thick, radius), point(sector + 1, -thick, radius),
        point(sector + 1, thick, radius), point(sector, thick, radius)], tone: slice % 2 });
    }
  }
  return faces;
}
