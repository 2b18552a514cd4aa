// Rational numbers as pairs of integers, and random ones: an arithmetic of its own for tests of what is computed in doubles.

/** A generator of numbers in [0, 1) from a seed (mulberry32). */
export function chance(seed) {
  let state = seed;
  const random = () => {
    state = state + 0x6D2B79F5 | 0;
    let t = Math.imul(state ^ state >>> 15, state | 1);
    t ^= t + Math.imul(t ^ t >>> 7, t | 61);
    return ((t ^ t >>> 14) >>> 0) / 4294967296;
  };
  const below = (n) => Math.floor(random() * n);
  return { random, below, one: (all) => all[below(all.length)] };
}

const size = (n) => n < 0n ? -n : n;
const divisor = (a, b) => b ? divisor(b, a % b) : size(a);

/** p/q in lowest terms, q positive. */
export function ratio(p, q = 1n) {
  const common = divisor(p, q) * (q < 0n ? -1n : 1n);
  return [p / common, q / common];
}

export const add = ([p, q], [r, s]) => ratio(p * s + r * q, q * s);
export const negative = ([p, q]) => [-p, q];
export const subtract = (a, b) => add(a, negative(b));
export const multiply = ([p, q], [r, s]) => ratio(p * r, q * s);
export const divide = ([p, q], [r, s]) => ratio(p * s, q * r);
export const absolute = ([p, q]) => [size(p), q];
export const sign = ([p]) => p > 0n ? 1 : p < 0n ? -1 : 0;
export const below = (a, b) => sign(subtract(a, b)) < 0;

/** A double as the rational number that it is. */
export function exactly(x) {
  let exponent = 0;
  while (!Number.isInteger(x)) [x, exponent] = [2 * x, exponent + 1];
  return ratio(BigInt(x), 2n ** BigInt(exponent));
}

/** The double nearest to a rational number. */
export function nearest([p, q]) {
  if (p === 0n) return 0;
  let shift = size(p).toString(2).length - q.toString(2).length - 64;
  shift = Math.max(shift, -1074 - 10);                  // no digit below the smallest double matters but that there is one
  const [above, under] = shift > 0 ? [size(p), q << BigInt(shift)] : [size(p) << BigInt(-shift), q];
  const whole = above / under | (above % under ? 1n : 0n);
  return (p < 0n ? -1 : 1) * scaled(whole, shift);
}

/** whole 2^shift, rounded once, to the even one of two that are as near. */
function scaled(whole, shift) {
  const excess = Math.max(whole.toString(2).length - 53, -1074 - shift, 0), unit = 1n << BigInt(excess);
  let kept = whole / unit;
  const rest = 2n * (whole % unit);
  if (rest > unit || rest === unit && kept % 2n) kept += 1n;
  return Number(kept) * 2 ** Math.max(shift + excess, -1000) * 2 ** Math.min(shift + excess + 1000, 0);
}

/** The results of all steps of a program without functions, at rational numbers; null of what divides by zero. */
export function results(steps, numbers) {
  const found = [], operations = { add, subtract, multiply, divide };
  for (const [operation, a, b] of steps) {
    if (operation === "name") found.push(numbers[a]);
    else if (operation === "number") found.push(exactly(a));
    else if (operation === "negative") found.push(found[a] && negative(found[a]));
    else if (!found[a] || !found[b] || operation === "divide" && !found[b][0]) found.push(null);
    else found.push(operations[operation](found[a], found[b]));
  }
  return found;
}
