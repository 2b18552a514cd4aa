// Programs of the library, as programs.py writes them, run in doubles; each result with a bound of its error.
const UNIT = 2 ** -53, TINY = 2 ** -1074;
export const SLACK = 1 + 2 ** -20;                      // what errors lose by rounding themselves

/**
 * An instruction on the results of earlier ones, which it names by their places.
 * @typedef {"add" | "subtract" | "multiply" | "divide"} Binary
 * @typedef {"negative" | "exp" | "log" | "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "sinh" | "cosh" | "tanh"
 *   | "asinh" | "acosh" | "atanh"} Unary
 * @typedef {["name", string, undefined?] | ["number", number, undefined?] | ["power", number, number]
 *   | [Binary, number, number] | [Unary, number, undefined?]} Step
 */
/**
 * A program: its instructions, the names that it needs, and the places of its results.
 * @typedef {{ steps: Step[], names: string[], results: number[] }} Program
 */
/** @typedef {Float64Array | number[]} Row */

// The bound of a step whose result is c, from those of its arguments (value a, error ea): Higham, Accuracy and
// Stability of Numerical Algorithms, 2nd ed. (2002), §3.3. Of functions, which JavaScript gives to 4 units, by the
// mean value theorem: `steepest` is the largest slope between a - ea and a + ea, Infinity where there is none.
/** @typedef {[value: number, error: number]} Enclosed */
/** @type {(c: number, steepest: number, ea: number) => Enclosed} */
const near = (c, steepest, ea) => [c, steepest * ea + 8 * UNIT * Math.abs(c) + TINY];
/** @type {(inside: number, slope: (inside: number) => number) => number} */
const where = (inside, slope) => inside > 0 ? slope(inside) : Infinity;
/** @type {(a: number, ea: number) => number} */
const left = (a, ea) => 1 - (Math.abs(a) + ea) ** 2 - 8 * UNIT;         // of 1, for asin, acos and atanh
/** @type {Record<Binary | Unary | "power", (a: number, ea: number, b: number, eb: number) => Enclosed>} */
const STEPS = {
  add: (a, ea, b, eb) => [a + b, ea + eb],
  subtract: (a, ea, b, eb) => [a - b, ea + eb],
  multiply: (a, ea, b, eb) => [a * b, Math.abs(a) * eb + Math.abs(b) * ea + ea * eb + TINY],
  divide: (a, ea, b, eb) => {
    const least = Math.abs(b) - eb;
    return [a / b, least > 0 ? (ea + Math.abs(a / b) * eb) / least + TINY : Infinity];
  },
  negative: (a, ea) => [-a, ea],
  power: (a, ea, n) => {
    const slope = (/** @type {number} */ x) => Math.abs(n) * x ** (n - 1);
    const [c, error] = near(a ** n, where(a - ea, (low) => Math.max(slope(low), slope(a + ea))), ea);
    return [c, error + Math.abs(n * Math.log(a)) * UNIT * c];           // n is rounded too
  },
  exp: (a, ea) => near(Math.exp(a), Math.exp(a + ea), ea),
  log: (a, ea) => near(Math.log(a), where(a - ea, (low) => 1 / low), ea),
  sin: (a, ea) => near(Math.sin(a), 1, ea),
  cos: (a, ea) => near(Math.cos(a), 1, ea),
  tan: (a, ea) => near(Math.tan(a), where(Math.abs(Math.cos(a)) - ea - 8 * UNIT, (least) => 1 / least ** 2), ea),
  asin: (a, ea) => near(Math.asin(a), where(left(a, ea), (least) => 1 / Math.sqrt(least)), ea),
  acos: (a, ea) => near(Math.acos(a), where(left(a, ea), (least) => 1 / Math.sqrt(least)), ea),
  atan: (a, ea) => near(Math.atan(a), 1, ea),
  sinh: (a, ea) => near(Math.sinh(a), Math.cosh(Math.abs(a) + ea), ea),
  cosh: (a, ea) => near(Math.cosh(a), Math.sinh(Math.abs(a) + ea), ea),
  tanh: (a, ea) => near(Math.tanh(a), 1, ea),
  asinh: (a, ea) => near(Math.asinh(a), 1, ea),
  acosh: (a, ea) => near(Math.acosh(a), where(a - ea - 1, (over) => 1 / Math.sqrt(2 * over)), ea),
  atanh: (a, ea) => near(Math.atanh(a), where(left(a, ea), (least) => 1 / least), ea),
};

const ROUNDED = new Set(["add", "subtract", "multiply", "divide"]);

/**
 * One step over a row: into value and error, from arguments that are a row or one number.
 * @param {Binary | Unary | "power"} operation
 * @param {Float64Array} value
 * @param {Float64Array} error
 * @param {Row} a
 * @param {Row} ea
 * @param {Row} b
 * @param {Row} eb
 */
function over(operation, value, error, a, ea, b, eb) {
  const n = value.length, sa = a.length > 1 ? 1 : 0, sb = b.length > 1 ? 1 : 0;
  if (operation === "add" || operation === "subtract") {
    const sign = operation === "add" ? 1 : -1;
    for (let i = 0, p = 0, q = 0; i < n; i++, p += sa, q += sb) {
      const c = a[p] + sign * b[q];
      value[i] = c;
      error[i] = ea[p] + eb[q] + UNIT * Math.abs(c);
    }
  } else if (operation === "multiply") {
    for (let i = 0, p = 0, q = 0; i < n; i++, p += sa, q += sb) {
      const c = a[p] * b[q];
      value[i] = c;
      error[i] = Math.abs(a[p]) * eb[q] + Math.abs(b[q]) * ea[p] + ea[p] * eb[q] + UNIT * Math.abs(c) + TINY;
    }
  } else {
    for (let i = 0, p = 0, q = 0; i < n; i++, p += sa, q += sb) {
      const [c, e] = STEPS[operation](a[p], ea[p] * SLACK, b[q], eb[q] * SLACK);
      value[i] = c;
      error[i] = e + (ROUNDED.has(operation) ? UNIT * Math.abs(c) : 0);
    }
  }
}

/**
 * The same without errors, of the operations of polynomials.
 * @param {string} operation
 * @param {Float64Array} value
 * @param {Row} a
 * @param {Row} b
 */
function values(operation, value, a, b) {
  const n = value.length;
  if (operation === "negative") for (let i = 0; i < n; i++) value[i] = -a[i];
  else if (operation === "multiply") {
    if (a.length === 1) [a, b] = [b, a];
    const y = b[0];
    if (b.length < n || n === 1) for (let i = 0; i < n; i++) value[i] = a[i] * y;
    else for (let i = 0; i < n; i++) value[i] = a[i] * b[i];
  } else {
    const sign = operation === "add" ? 1 : -1, x = a[0], y = sign * b[0];
    if (b.length < n || n === 1) for (let i = 0; i < n; i++) value[i] = a[i] + y;
    else if (a.length < n) for (let i = 0; i < n; i++) value[i] = x + sign * b[i];
    else for (let i = 0; i < n; i++) value[i] = a[i] + sign * b[i];
  }
}

const POLYNOMIAL = new Set(["add", "subtract", "multiply", "negative"]);
/** @type {(row: Float64Array) => number} */
const most = (row) => row.reduce((a, b) => Math.max(a, Math.abs(b)), 0);

/**
 * Whether a step varies across (1), upwards (2), both (3), or not at all (0).
 * @param {Step[]} steps
 * @param {string[]} axes
 */
function varying(steps, [across, upwards]) {
  /** @type {number[]} */
  const kinds = [];
  for (const [operation, a, b] of steps) {
    if (operation === "name") kinds.push(a === across ? 1 : a === upwards ? 2 : 0);
    else if (operation === "number") kinds.push(0);
    else kinds.push(kinds[a] | (operation === "power" || b === undefined ? 0 : kinds[b]));
  }
  return kinds;
}

/** The results of a program over the rows of a picture, each with its error; or, quickly, with one for all. */
export class Rows {
  /**
   * @param {Step[]} steps
   * @param {string[]} axes the names across and upwards
   * @param {number} width of a row, in pixels
   */
  constructor(steps, axes, width) {
    this.steps = steps;
    this.kinds = varying(steps, axes);
    const room = () => this.kinds.map((kind) => new Float64Array(kind & 1 ? width : 1));
    this.values = room();
    this.errors = room();
    this.y = 0;
    /** @type {Record<string, number | Row>} */
    this.numbers = {};
    /** @type {number[]} */
    this.sizes = [];
    /** @type {number[]} */
    this.bounds = [];
    this.polynomial = steps.every(([operation], i) => this.kinds[i] < 2 || operation === "name" || POLYNOMIAL.has(operation));
  }

  /**
   * What does not vary upwards; and the one error for all.
   * @param {Record<string, number | Row>} numbers of the names; of the one across an array
   * @param {number} upwards the largest absolute value of the name upwards
   */
  begin(numbers, upwards) {
    this.numbers = numbers;
    this.y = upwards;
    this.take((kind) => kind < 2);
    this.sizes = this.values.map(most);
    this.bounds = this.errors.map(most);
    this.steps.forEach(([operation, a, b], i) => {
      if (this.kinds[i] < 2) return;
      const [sizes, bounds] = [this.sizes, this.bounds];
      if (operation === "name") [sizes[i], bounds[i]] = [upwards, UNIT * upwards];
      else if (operation === "negative") [sizes[i], bounds[i]] = [sizes[a], bounds[a]];
      else if (operation === "add" || operation === "subtract") {
        sizes[i] = sizes[a] + sizes[b];
        bounds[i] = bounds[a] + bounds[b] + UNIT * sizes[i];
      } else if (operation === "multiply") {
        sizes[i] = (sizes[a] + bounds[a]) * (sizes[b] + bounds[b]);
        bounds[i] = STEPS.multiply(sizes[a], bounds[a], sizes[b], bounds[b])[1] + UNIT * sizes[i];
      }
    });
  }

  /**
   * The rest, in the row where the name upwards is y.
   * @param {number} y
   * @param {boolean} errors whether each result has an error of its own
   */
  row(y, errors) {
    this.y = y;
    this.take((kind) => kind > 1, errors);
  }

  /**
   * Those steps whose kind is wanted.
   * @param {(kind: number) => boolean} wanted
   */
  take(wanted, errors = true) {
    this.steps.forEach(([operation, a, b], i) => {
      if (!wanted(this.kinds[i])) return;
      const value = this.values[i], error = this.errors[i];
      if (operation === "number" || operation === "name") {
        const given = operation === "number" ? a : this.kinds[i] === 2 ? this.y : this.numbers[a];
        if (typeof given === "number") value.fill(given);
        else value.set(given);
        for (let n = 0; n < value.length; n++) error[n] = UNIT * Math.abs(value[n]);
      } else if (operation === "power" || b === undefined) {              // b, if there is one, is an exponent
        if (errors) over(operation, value, error, this.values[a], this.errors[a], [b ?? 0], [0]);
        else values(operation, value, this.values[a], []);
      } else if (errors) {
        over(operation, value, error, this.values[a], this.errors[a], this.values[b], this.errors[b]);
      } else {
        values(operation, value, this.values[a], this.values[b]);
      }
    });
  }
}
