// Paints a body in space on a 2D context, that of a canvas or one that writes SVG.
import { combined, cross, dot, turned, unit, vector } from "../numerics/attitude.js";
import { exit, wheel } from "./solids.js";

/** @typedef {import("../numerics/attitude.js").Vector} Vector */
/** @typedef {import("../numerics/attitude.js").Matrix} Matrix */
/** @typedef {import("./colours.js").Colours} Colours */

/**
 * @typedef {object} Picture
 * @property {import("./solids.js").Solid} solid
 * @property {Matrix} axes the principal axes, in the axes of the body
 * @property {Matrix} attitude from the axes of the body to those of space
 * @property {{ axle: Vector, angle: number } | null} rotor its direction, in the axes of the body
 * @property {{ direction: Vector, name: string }[]} frame what stands still
 * @property {{ axes: Matrix, past: Vector[][], age: number[], ahead: Vector[] }} path in which axes it is, its
 *   pieces that are past, from the oldest on, the age of each from 0 to 1, and what is to come
 * @property {string} verdict "" of none
 * @property {[number, number]} view by how much the eye is turned about the vertical and raised, in rad
 */

/** @typedef {{ shown: Vector[], facing: number, colour: string }} Shown from outside (1), inside (-1), aside */
/** @typedef {{ name: string, length: number, colour: string, width: number, aside: number }} Style */
/** @typedef {Style & { from: Vector, to: Vector, front: boolean }} Ray */

const FAR = 7;                                          // of the eye, where the axes have the length 1
const SHARE = 0.36;                                     // of the picture that is the length 1
const MIDDLE = [0.5, 0.53];                             // where the centre is
const GLASS = 0.5;                                      // how much of the wheel a face before it hides
const SUN = unit([-0.5, 0.8, -0.6]);                    // to the light: across, up, away
/** @type {Record<string, number[]>} */
const DASHES = { STABLE: [], UNSTABLE: [7, 4], UNDECIDED: [2, 3], "": [] };
const CIRCLE = Array.from({ length: 73 }, (_, n) => n * Math.PI / 36).map((angle) =>
  unit([Math.cos(angle), Math.sin(angle), 0]));

/** @param {[number, number]} view @returns {Matrix} the directions across, up and away from the eye */
function eye([turn, tilt]) {
  const c = Math.cos(turn), s = Math.sin(turn), low = Math.cos(tilt), high = Math.sin(tilt);
  return [[c, -s, 0], [s * high, c * high, low], [s * low, c * low, -high]];
}

class Painter {
  /** @param {any} context @param {number} size @param {Matrix} looking */
  constructor(context, size, looking) {
    this.context = context;
    this.size = size;
    this.looking = looking;
  }

  /** @param {Vector} point @returns {Vector} where it is in the picture, and how far behind the centre */
  seen(point) {
    const [across, up, away] = turned(this.looking, point), scale = SHARE * this.size * FAR / (FAR + away);
    return [MIDDLE[0] * this.size + scale * across, MIDDLE[1] * this.size - scale * up, away];
  }

  /** @param {Vector[]} points of a face in space @param {number[]} rgb its colour @returns {Shown} */
  shaped(points, rgb) {
    const shown = points.map((point) => this.seen(point)), [a, b, c] = points;
    const area = shown.reduce((sum, [x, y], n) => {
      const [u, v] = shown[(n + 1) % shown.length];
      return sum + x * v - u * y;
    }, 0);
    const facing = -Math.sign(area);
    const normal = turned(this.looking, unit(cross(vector((n) => b[n] - a[n]), vector((n) => c[n] - a[n]))));
    const light = 0.66 + 0.34 * facing * dot(normal, SUN);
    return { shown, facing, colour: `rgb(${rgb.map((x) => Math.round(x * light)).join(", ")})` };
  }

  /** @param {Shown} face @param {number} alpha @param {string} edge its colour, "" of none */
  fill({ shown, colour }, alpha, edge) {
    const { context } = this;
    context.beginPath();
    shown.forEach(([x, y], n) => n ? context.lineTo(x, y) : context.moveTo(x, y));
    context.closePath();
    Object.assign(context, { globalAlpha: alpha, fillStyle: colour });
    context.fill();
    Object.assign(context, edge ? { globalAlpha: 0.6, strokeStyle: edge, lineWidth: 1 }
      : { strokeStyle: colour, lineWidth: 0.5 });       // no gap is seen between faces of one colour
    context.stroke();
  }

  /** The parts of a line before the centre, or behind. @param {Vector[]} points @param {boolean} front */
  line(points, front) {
    const { context } = this;
    let before = false;
    context.beginPath();
    points.map((point) => this.seen(point)).forEach(([x, y, away], n, all) => {
      const here = away <= 0 === front;
      if (here && before) context.lineTo(x, y);
      else if (here && n) {
        context.moveTo(all[n - 1][0], all[n - 1][1]);
        context.lineTo(x, y);
      } else if (here) context.moveTo(x, y);
      before = here;
    });
    context.stroke();
  }

  /** The horizon of the sphere of the path, and its outline. @param {boolean} front @param {string} colour */
  sphere(front, colour) {
    const { context, size } = this;
    Object.assign(context, { strokeStyle: colour, lineWidth: 1, globalAlpha: front ? 0.8 : 0.5 });
    this.line(CIRCLE, front);
    if (front) return;
    context.beginPath();
    const radius = SHARE * size * FAR / Math.sqrt(FAR * FAR - 1);
    context.arc(MIDDLE[0] * size, MIDDLE[1] * size, radius, 0, 2 * Math.PI);
    context.stroke();
  }

  /** @param {Picture} picture @param {boolean} front @param {string} colour */
  path({ path: { axes, past, age, ahead }, verdict }, front, colour) {
    const { context } = this, strength = front ? 1 : 0.45;
    /** @param {Vector[]} points */
    const placed = (points) => points.map((point) => turned(axes, point));
    Object.assign(context, { strokeStyle: colour, lineWidth: 1, globalAlpha: 0.45 * strength });
    context.setLineDash(DASHES[verdict]);
    this.line(placed(ahead), front);
    context.lineWidth = 2;
    past.forEach((piece, n) => {
      context.globalAlpha = strength * (1 - age[n]);
      this.line(placed(piece), front);
    });
    context.setLineDash([]);
    const [tip] = placed(past.flatMap((piece) => piece.slice(-1)).slice(-1)).map((point) => this.seen(point));
    if (!tip || tip[2] <= 0 !== front) return;
    Object.assign(context, { fillStyle: colour, globalAlpha: 1 });
    context.beginPath();
    context.arc(tip[0], tip[1], 4, 0, 2 * Math.PI);
    context.fill();
  }

  /** Where an arrow begins and ends, how long it is and which way it goes. @param {Ray} ray */
  ends({ from, to }) {
    const [x, y] = this.seen(from), [u, v] = this.seen(to), long = Math.hypot(u - x, v - y);
    return { x, y, u, v, long, p: long ? (u - x) / long : 0, q: long ? (v - y) / long : -1 };
  }

  /** @param {Ray} ray */
  arrow(ray) {
    const { context, size } = this, { x, y, u, v, long, p, q } = this.ends(ray), { colour } = ray;
    const head = size / 50;
    Object.assign(context, { strokeStyle: colour, fillStyle: colour, lineWidth: ray.width, globalAlpha: 1 });
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
  }

  /**
   * The name of an arrow, before its tip or aside; none behind the body.
   * @param {Ray} ray
   * @param {Shown[]} body
   */
  name(ray, body) {
    const { context, size } = this, { u, v, p, q } = this.ends(ray), { name, aside } = ray;
    const across = aside * size / 24, along = aside ? 0 : size * (0.04 + 0.011 * name.length * Math.abs(p));
    const edge = size * 0.015 * (1 + name.length);
    const x = Math.min(size - edge, Math.max(edge, u + p * along - q * across));
    const y = Math.min(size * 0.97, Math.max(size * 0.03, v + q * along + p * across));
    if (!ray.front && body.some(({ shown, facing }) => facing > 0 && inside(shown, x, y))) return;
    Object.assign(context, { fillStyle: ray.colour, globalAlpha: 1, textAlign: "center",
      textBaseline: "middle", font: `${Math.round(size / 25)}px system-ui, sans-serif` });
    context.fillText(name, x, y);
  }
}

/** @param {Vector[]} shown the corners of a face, seen from outside @param {number} x @param {number} y */
const inside = (shown, x, y) => shown.every(([a, b], n) => {
  const [c, d] = shown[(n + 1) % shown.length];
  return (c - a) * (y - b) <= (d - b) * (x - a);
});

// Whether a face of the wheel is before the body (1), behind it (-1), or inside (0).
/** @type {(solid: import("./solids.js").Solid, corners: Vector[], eye: Vector) => number} */
function outside({ kind, half }, corners, eye) {
  const centre = vector((n) => corners.reduce((sum, corner) => sum + corner[n], 0) / corners.length);
  if (kind === "ellipsoid") {
    return Math.hypot(...centre.map((x, n) => x / half[n])) <= 1 ? 0 : Math.sign(dot(centre, eye));
  }
  const out = [0, 1, 2].filter((n) => Math.abs(centre[n]) > half[n]);
  return !out.length ? 0 : out.some((n) => Math.sign(centre[n]) * eye[n] > half[n]) ? 1 : -1;
}

/**
 * From behind to the front: what is behind the body, the body with its wheel, what is before it.
 * @param {any} context
 * @param {number} size its width and height
 * @param {Picture} picture
 * @param {Colours} colours
 */
export function paint(context, size, picture, colours) {
  const { solid, axes, attitude, rotor, frame, verdict, view } = picture, looking = eye(view);
  const painter = new Painter(context, size, looking), edge = solid.kind === "box" ? colours.ink : "";
  /** @type {Matrix} */
  const own = [turned(attitude, axes[0]), turned(attitude, axes[1]), turned(attitude, axes[2])];
  const from = vector((n) => -FAR * looking[2][n]), eyed = turned(own, from);
  /** @type {(direction: Vector, style: Style) => Ray} */
  const ray = (direction, style) => {
    const within = turned(own, direction), { reach, normal } = exit(solid, within);
    const front = dot(normal, vector((n) => eyed[n] - reach * within[n])) > 0;
    return { ...style, from: vector((n) => reach * direction[n]), front,
      to: vector((n) => style.length * direction[n]) };
  };
  const still = { length: 1.2, colour: colours.quiet, width: 2, aside: 0 };
  const axis = { length: 1, colour: colours.ink, width: 1.25, aside: 1 };
  const axle = { length: 0.82, colour: colours.ink, width: 3, aside: -1 };
  const rays = [...frame.map(({ direction, name }) => ray(direction, { ...still, name })),
    ...own.map((direction, n) => ray(direction, { ...axis, name: `e${"₁₂₃"[n]}` })),
    ...rotor ? [ray(turned(attitude, rotor.axle), { ...axle, name: "l" })] : []];
  /** @param {Vector[]} corners @param {number[]} rgb */
  const shaped = (corners, rgb) => painter.shaped(corners.map((corner) => combined(own, corner)), rgb);
  const body = solid.faces.map(({ corners, tone }) => shaped(corners, colours.body[tone]));
  const slices = rotor ? wheel(solid, turned(axes, rotor.axle), rotor.angle).map(({ corners, tone }) =>
    ({ ...shaped(corners, colours.wheel[tone]), place: outside(solid, corners, eyed) })) : [];
  /** @param {number} place */
  const turning = (place) => {
    for (const face of slices) if (face.facing > 0 && face.place === place) painter.fill(face, 1, "");
  };
  /** @param {boolean} front */
  const around = (front) => {
    painter.sphere(front, colours.line);
    painter.path(picture, front, colours.verdicts[verdict]);
    for (const arrow of rays) if (arrow.front === front) painter.arrow(arrow);
  };
  turning(-1);
  around(false);
  if (rotor) for (const face of body) if (face.facing < 0) painter.fill(face, 0.8, edge);
  turning(0);
  for (const face of body) if (face.facing > 0) painter.fill(face, rotor ? GLASS : 1, edge);
  turning(1);
  around(true);
  for (const arrow of rays) painter.name(arrow, body);
}
