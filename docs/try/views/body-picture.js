// Draws a body in space on a 2D context of any kind: a canvas, or one that writes SVG.
import { dot, turned, unit } from "../numerics/attitude.js";
import { exit, wheel } from "./solids.js";

/** @typedef {import("../numerics/attitude.js").Vector} Vector */
/** @typedef {import("../numerics/attitude.js").Matrix} Matrix */

/**
 * @typedef {object} Picture
 * @property {import("./solids.js").Solid} solid
 * @property {Matrix} axes the principal axes, in the axes of the body
 * @property {Matrix} attitude from the axes of the body to those of space
 * @property {{ axle: Vector, angle: number } | null} rotor its direction in the axes of the body, and how far it is turned
 * @property {{ direction: Vector, name: string }[]} frame what stands still
 * @property {{ axes: Matrix, past: Vector[][], age: number[], ahead: Vector[] }} path its axes, pieces that have been
 *   passed, the oldest first, how old each is from 0 to 1, and what is to come
 * @property {string} verdict "" of none
 * @property {[number, number]} view by how much the eye is turned about the vertical and raised, in rad
 */

/** @typedef {(point: Vector) => Vector} Projection across, down, and how far behind the centre */

const FAR = 7;                                          // of the eye, where axes have the length 1
const SHARE = 0.345;                                    // of the picture that is the length 1
/** @type {Record<string, number[]>} */
const DASHES = { STABLE: [], UNSTABLE: [7, 4], UNDECIDED: [2, 3], "": [] };
const GLASS = 0.5;                                      // how much a face hides of the wheel behind it
const SUN = unit([-0.5, 0.8, -0.6]);                    // to the light: across, up, behind

/** @param {[number, number]} view */
function eye([turn, tilt]) {
  const c = Math.cos(turn), s = Math.sin(turn), low = Math.cos(tilt), high = Math.sin(tilt);
  /** @type {Matrix} */
  return [[c, -s, 0], [s * high, c * high, low], [s * low, c * low, -high]];
}

/**
 * Where a point of space is in a picture.
 * @param {number} size
 * @param {[number, number]} view
 * @returns {Projection}
 */
export function projection(size, view) {
  const [across, up, behind] = eye(view);
  return (point) => {
    const depth = dot(behind, point), scale = SHARE * size * FAR / (FAR + depth);
    return [size / 2 + scale * dot(across, point), size / 2 - scale * dot(up, point), depth];
  };
}

/**
 * @param {any} context
 * @param {number} size its width and height
 * @param {Picture} picture
 * @param {import("./colours.js").Colours} colours
 */
export function paint(context, size, picture, colours) {
  const { solid, axes, attitude, rotor, frame, verdict, view } = picture;
  const seen = projection(size, view), looking = eye(view), to = looking[2].map((x) => -FAR * x);
  const columns = axes.map((axis) => turned(attitude, axis));
  /** @type {(x: number[]) => Vector} from principal axes to space */
  const placed = (x) => [0, 1, 2].map((n) => x[0] * columns[0][n] + x[1] * columns[1][n] + x[2] * columns[2][n]);
  /** @type {(x: number[]) => Vector} and back */
  const within = (x) => columns.map((column) => dot(column, x));
  const rays = [
    ...frame.map(({ direction, name }) => ({ direction, name, length: 1.24, colour: colours.quiet, width: 2, aside: 0 })),
    ...columns.map((direction, n) => ({ direction, name: `e${"₁₂₃"[n]}`, length: 1, colour: colours.ink, width: 1.25, aside: 1 })),
    ...rotor ? [{ direction: turned(attitude, rotor.axle), name: "l", length: 0.82, colour: colours.ink, width: 3, aside: -1 }] : [],
  ].map((ray) => {
    const { reach, normal } = exit(solid, within(ray.direction)), from = ray.direction.map((x) => x * reach);
    return { ...ray, from, front: dot(placed(normal), to.map((x, n) => x - from[n])) > 0 };
  });
  const body = solid.faces.map((face) => shaped(face, colours.body, placed, seen, looking));
  const parts = rotor ? wheel(solid, unit(within(turned(attitude, rotor.axle))), rotor.angle)
    .map((face) => ({ ...shaped(face, colours.wheel, placed, seen, looking), beyond: beyond(solid, face, within(to)) })) : [];

  for (const front of [false, true]) {
    if (front) {
      if (rotor) for (const face of body) if (face.facing < 0) fill(context, face, 0.8, solid.kind, colours.ink);
      for (const face of parts) if (face.facing > 0 && face.beyond === 0) fill(context, face, 1, "wheel", colours.ink);
      for (const face of body) if (face.facing > 0) fill(context, face, rotor ? GLASS : 1, solid.kind, colours.ink);
    }
    for (const face of parts) if (face.facing > 0 && face.beyond === (front ? 1 : -1)) fill(context, face, 1, "wheel", colours.ink);
    circles(context, size, seen, front, colours);
    path(context, picture, seen, front, colours);
    for (const ray of rays) if (ray.front === front) arrow(context, size, ray, seen);
  }
  context.globalAlpha = 1;
}

/** Whether a face of the wheel is outside of the body: 1 before it, -1 behind it, 0 inside. */
function beyond({ kind, half }, { corners }, to) {
  const centre = [0, 1, 2].map((n) => corners.reduce((sum, corner) => sum + corner[n], 0) / corners.length);
  if (kind === "ellipsoid") return Math.hypot(...centre.map((x, n) => x / half[n])) <= 1 ? 0 : dot(centre, to) > 0 ? 1 : -1;
  const out = [0, 1, 2].filter((n) => Math.abs(centre[n]) > half[n]);
  if (!out.length) return 0;
  return out.some((n) => Math.sign(centre[n]) * to[n] > half[n]) ? 1 : -1;
}

/** A face on the picture, whether its outside is seen (1), its inside (-1) or its edge (0), and its colour in the light. */
function shaped({ corners, tone }, tones, placed, seen, looking) {
  const points = corners.map(placed), shown = points.map(seen);
  let area = 0;
  shown.forEach(([x, y], n) => {
    const [u, v] = shown[(n + 1) % shown.length];
    area += x * v - u * y;
  });
  const [a, b, c] = points, facing = Math.abs(area) < 1e-9 ? 0 : -Math.sign(area);
  const normal = [0, 1, 2].map((n) => b[n] - a[n]), other = [0, 1, 2].map((n) => c[n] - a[n]);
  const across = turned(looking, unit([normal[1] * other[2] - normal[2] * other[1],
    normal[2] * other[0] - normal[0] * other[2], normal[0] * other[1] - normal[1] * other[0]]));
  const light = 0.66 + 0.34 * facing * dot(across, SUN);
  return { shown, facing, colour: `rgb(${tones[tone].map((x) => Math.round(Math.min(255, x * light))).join(", ")})` };
}

function fill(context, { shown, colour }, alpha, kind, ink) {
  context.globalAlpha = alpha;
  context.beginPath();
  shown.forEach(([x, y], n) => n ? context.lineTo(x, y) : context.moveTo(x, y));
  context.closePath();
  context.fillStyle = colour;
  context.fill();
  context.lineWidth = kind === "box" ? 1 : 0.5;
  context.strokeStyle = kind === "box" ? ink : colour;
  context.globalAlpha = kind === "box" ? 0.6 : alpha;
  context.stroke();
  context.globalAlpha = 1;
}

/** A line through points of space, those of it that are before the centre or behind. */
function line(context, points, seen, front) {
  let drawing = false;
  context.beginPath();
  let last;
  for (const point of points) {
    const [x, y, depth] = seen(point), here = (depth <= 0) === front;
    if (here && drawing) context.lineTo(x, y);
    else if (here) {
      if (last) {
        context.moveTo(...last);
        context.lineTo(x, y);
      } else context.moveTo(x, y);
    }
    drawing = here;
    last = [x, y];
  }
  context.stroke();
}

const ROUND = Array.from({ length: 73 }, (_, n) => [Math.cos(n * Math.PI / 36), Math.sin(n * Math.PI / 36), 0]);

/** The horizon of the sphere on which tips move, and its outline. */
function circles(context, size, seen, front, { line: colour }) {
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash([]);
  context.globalAlpha = front ? 0.8 : 0.5;
  line(context, ROUND, seen, front);
  if (front) return;
  context.beginPath();
  context.arc(size / 2, size / 2, SHARE * size * FAR / Math.sqrt(FAR * FAR - 1), 0, 2 * Math.PI);
  context.stroke();
}

function path(context, { path: { axes, past, age, ahead }, verdict }, seen, front, colours) {
  const placed = (point) => turned(axes, point), strength = front ? 1 : 0.45;
  context.strokeStyle = colours.verdicts[verdict];
  context.setLineDash(DASHES[verdict]);
  context.lineWidth = 1;
  context.globalAlpha = 0.45 * strength;
  line(context, ahead.map(placed), seen, front);
  context.lineWidth = 2;
  past.forEach((piece, n) => {
    context.globalAlpha = strength * (1 - age[n]);
    line(context, piece.map(placed), seen, front);
  });
  context.setLineDash([]);
  context.globalAlpha = 1;
  const tip = past.at(-1)?.at(-1);
  if (!tip) return;
  const [x, y, depth] = seen(placed(tip));
  if ((depth <= 0) !== front) return;
  context.fillStyle = colours.verdicts[verdict];
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fill();
}

/** From the surface of the body to its tip, and its name behind the tip or aside. */
function arrow(context, size, { direction, from, length, name, colour, width, aside }, seen) {
  const [x, y] = seen(from), [u, v] = seen(direction.map((entry) => entry * length));
  const long = Math.hypot(u - x, v - y), head = size / 50, [p, q] = long ? [(u - x) / long, (v - y) / long] : [0, -1];
  Object.assign(context, { strokeStyle: colour, fillStyle: colour, lineWidth: width, globalAlpha: 1 });
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(u, v);
  context.stroke();
  if (long > head) {
    context.beginPath();
    context.moveTo(u + p * head / 2, v + q * head / 2);
    context.lineTo(u - (p + q) * head / 2, v - (q - p) * head / 2);
    context.lineTo(u - (p - q) * head / 2, v - (q + p) * head / 2);
    context.closePath();
    context.fill();
  }
  Object.assign(context, { font: `${Math.round(size / 25)}px system-ui, sans-serif`, textAlign: "center",
    textBaseline: "middle" });
  const away = size / 24, [across, along] = aside ? [aside * away, 0] : [0, 1.1 * away];
  context.fillText(name, u + p * along - q * across, v + q * along + p * across);
}
