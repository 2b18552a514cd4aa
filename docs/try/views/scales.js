// From where to where a slider and a chart go: one scale for each name, which both use; numbers on it, zoom.

/** @typedef {[number, number]} Ends  the lowest number of a scale, and the highest */
/**
 * @typedef {{name: string, text: string, positive: boolean, dimension: number[] | null}} Name  what the
 *   library says of a name: its dimension is [a, b, c] for [M L²]ᵃ [T]⁻ᵇ [L]ᶜ, null for a parameter of the
 *   visitor
 */
/**
 * @typedef {{of: Name, ends: Ends, whole: Ends, open: boolean}} Scale  its ends; those before a zoom; whether
 *   a number may have been typed that the ends have not been compared with yet
 */

const SMALL = 1000;                                     // numbers below this part of a scale are not seen
const COMPONENT = /^[knr][123]$/;                       // of a unit vector

/** A double that is written in few digits. @param {number} x @returns {number} */
const clean = (x) => Number(x.toPrecision(12)) + 0;     // + 0: there is no -0

/** The least of 1, 2, 5, 10, … that is not below x. @param {number} x @returns {number} */
export function nice(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return clean(power * ([1, 2, 5].find((digit) => digit * power >= x * (1 - 1e-9)) ?? 10));
}

/**
 * Whether numbers of a name are positive; the library takes M = 0 too, which needs no place on a slider.
 * @param {Name} name
 * @returns {boolean}
 */
const isPositive = ({ name, positive }) => positive || name === "M";

/**
 * What a quantity of some dimension is about in a scene: moments of inertia are about the geometric mean of
 * those that are known, rates about that of the rates, and of the rates that momenta and energies have with
 * such a moment.
 * @param {Name[]} names
 * @param {(name: string) => number} number NaN where none is known
 * @returns {(dimension: number[] | null) => number}
 */
function typical(names, number) {
  const known = names.map(({ name, dimension }) => ({ size: Math.abs(number(name)), dimension }))
    .filter(({ size, dimension }) => size > 0 && size < Infinity && dimension && !dimension[2])
    .map(({ size, dimension }) => ({ size, moment: dimension?.[0] ?? 0, rate: dimension?.[1] ?? 0 }));
  /** @param {number[]} sizes */
  const mean = (sizes) =>
    Math.exp(sizes.reduce((sum, size) => sum + Math.log(size), 0) / (sizes.length || 1));
  const moments = known.filter(({ moment, rate }) => moment === 1 && rate === 0);
  const inertia = mean(moments.map(({ size }) => size));
  const speed = mean(known.filter(({ rate }) => rate > 0)
    .map(({ size, moment, rate }) => (size / inertia ** moment) ** (1 / rate)));
  return (dimension) => dimension && !dimension[2] ? inertia ** dimension[0] * speed ** dimension[1] : 1;
}

/**
 * The scale that fits a number of a name; about: what it may be if the number is 0, or none.
 * @param {Name} name
 * @param {number} value
 * @param {number} about
 * @returns {Ends}
 */
export function fitting(name, value, about) {
  if (isPositive(name)) {
    const middle = Number((value > 0 ? value : about).toPrecision(1));
    return [clean(middle / 20), clean(5 * middle)];
  }
  if (COMPONENT.test(name.name) && !(Math.abs(value) > 1)) return [-1, 1];
  const most = nice(2.5 * (Math.abs(value) || about));
  return [-most, most];
}

/**
 * Whether a number has a place on a scale that can be told from that of 0.
 * @param {Ends} ends
 * @param {number} value
 */
const isSeen = ([low, high], value) => low <= value && value <= high
  && (value === 0 || Math.abs(value) * SMALL >= Math.max(-low, high));

/**
 * The scales of a scene: those that there are, but a new one where there is none, or where a number was typed
 * that is not seen on the old one.
 * @param {Map<string, Scale>} scales
 * @param {Name[]} names
 * @param {(name: string) => number} number
 * @param {Record<string, string[]>} given the ends of new ones that a link says
 * @returns {Map<string, Scale>}
 */
export function fitted(scales, names, number, given = {}) {
  const about = typical(names, number);
  /** @param {Name} name @returns {[string, Scale]} */
  const entry = (name) => {
    const old = scales.get(name.name), scale = fittedTo(old, name, number(name.name), about);
    const ends = !old && Object.hasOwn(given, name.name) && possible(name, given[name.name].map(Number));
    return [name.name, ends ? { ...scale, ends } : scale];
  };
  return new Map([...scales, ...names.map(entry)]);
}

/**
 * Ends that a name can have; null if they are none.
 * @param {Name} name
 * @param {number[]} ends
 * @returns {Ends | null}
 */
function possible(name, [low, high]) {
  const right = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)) && high - low < Infinity;
  return right && !(isPositive(name) && low <= 0) ? [low, high] : null;
}

/**
 * @param {Scale | undefined} old
 * @param {Name} name
 * @param {number} value
 * @param {(dimension: number[] | null) => number} about
 * @returns {Scale}
 */
function fittedTo(old, name, value, about) {
  const known = Number.isFinite(value);
  if (old && (!old.open || !known)) return { ...old, of: name };
  if (old && isSeen(old.ends, value)) return { ...old, of: name, open: false };
  if (old && isSeen(old.whole, value)) return { ...old, of: name, ends: old.whole, open: false };
  const ends = fitting(name, value, about(name.dimension));
  return { of: name, ends, whole: ends, open: !known };
}

/**
 * A scale around a number at one of its very ends, with as much beyond it as a new one would have.
 * @param {Scale} scale
 * @param {number} value
 * @returns {Scale}
 */
export function widened({ of, ends: [low, high] }, value) {
  const [lower, higher] = fitting(of, value, high);
  /** @type {Ends} */
  const ends = [Math.min(low, lower), Math.max(high, higher)];
  return { of, ends, whole: ends, open: false };
}

/**
 * A scale whose number at one share of it comes to another share, while all of it becomes so many times as
 * long: zoom, where both shares are one, and motion, where the factor is 1. Ends have five digits of their
 * distance; those of a positive name stay positive, those of a component of a unit vector between -1 and 1.
 * @param {Scale} scale
 * @param {number} from
 * @param {number} to
 * @param {number} factor
 * @returns {Scale}
 */
export function stretched(scale, from, to, factor) {
  const { of, ends: [low, high], whole } = scale, all = whole[1] - whole[0];
  const least = Math.max(1e-4 * Math.max(Math.abs(low), Math.abs(high)), 1e-6 * all);
  const span = Math.min(Math.max((high - low) * factor, Math.min(least, high - low)), 100 * all);
  let first = low + (high - low) * from - span * to, last = first + span;
  if (COMPONENT.test(of.name) && whole[0] === -1) {
    first = Math.max(-1, Math.min(first, 1 - span));
    last = Math.min(1, first + span);
  }
  const unit = 10 ** (Math.floor(Math.log10(last - first)) - 4);
  first = clean(Math.round(first / unit) * unit);
  last = clean(Math.round(last / unit) * unit);
  if (!isPositive(of) || first > 0) return { ...scale, ends: [first, last] };
  return { ...scale, ends: [low, factor === 1 ? high : last] };
}

/**
 * Whether a slider is logarithmic, so that small numbers have as much of it as large ones.
 * @param {Ends} ends
 */
export const isLogarithmic = ([low, high]) => low > 0 && high >= 10 * low;

/**
 * The power of ten to which numbers on a scale are rounded: the largest below its two hundredth part.
 * @param {Ends} ends
 * @returns {number}
 */
const unitOf = ([low, high]) => 10 ** Math.floor(Math.log10((high - low) / 200) + 1e-9);

/**
 * A number on a scale, with as many digits as a picture can tell.
 * @param {Ends} ends
 * @param {number} value
 */
export function rounded(ends, value) {
  const unit = unitOf(ends);
  return Math.min(Math.max(clean(Math.round(value / unit) * unit), ends[0]), ends[1]);
}

/** How many steps a slider has. @param {Ends} ends @returns {number} */
export function steps(ends) {
  const [low, high] = ends;
  return Math.round(isLogarithmic(ends) ? 200 * Math.log10(high / low) : (high - low) / unitOf(ends));
}

/**
 * The number at a step of a slider; of a logarithmic one it has three digits.
 * @param {Ends} ends
 * @param {number} step
 * @returns {number}
 */
export function numberAt(ends, step) {
  const [low, high] = ends, share = step / steps(ends);
  if (share <= 0) return low;
  if (share >= 1) return high;
  return isLogarithmic(ends) ? Number((low * (high / low) ** share).toPrecision(3))
    : rounded(ends, low + (high - low) * share);
}

/**
 * The step of a slider that is nearest to a number.
 * @param {Ends} ends
 * @param {number} value
 * @returns {number}
 */
export function stepOf(ends, value) {
  const [low, high] = ends, inside = Math.min(Math.max(value, low), high);
  const share = isLogarithmic(ends) ? Math.log(inside / low) / Math.log(high / low)
    : (inside - low) / (high - low);
  return Math.round(share * steps(ends));
}

/** A number as a visitor would type it. @param {number} value @returns {string} */
export const written = (value) =>
  value !== 0 && Math.abs(value) < 1e-4 ? value.toExponential() : String(value);
