// Programs of the library, as programs.py writes them, run in doubles; each result with a bound of its error.
const UNIT = 2 ** -53, TINY = 2 ** -1074;
export const SLACK = 1 + 2 ** -20;                      // what errors lose by rounding themselves

// The bound of a step whose result is c, from those of its arguments (value a, error ea): Higham, Accuracy and
// Stability of Numerical Algorithms, 2nd ed. (2002), §3.3. Of functions, which JavaScript gives to 4 units, by the
// mean value theorem: `steepest` is the largest slope between a - ea and a + ea, Infinity where there is none.
const near = (c, steepest, ea) => [c, steepest * ea + 8 * UNIT * Math.abs(c) + TINY];
const where = (inside, slope) => inside > 0 ? slope(inside) : Infinity;
const left = (a, ea) => 1 - (Math.abs(a) + ea) ** 2 - 8 * UNIT;         // of 1, for asin, acos and atanh
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
    const slope = (x) => Math.abs(n) * x ** (n - 1), [c, error] = near(a ** n, where(a - ea, (low) =>
      Math.max(slope(low), slope(a + ea))), ea);
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

// One step over a row: into value and error, from arguments that are a row or one number.
function over(operation, n, value, error, a, ea, b, eb) {
  const sa = a?.length > 1 ? 1 : 0, sb = b?.length > 1 ? 1 : 0;
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
      const [c, e] = STEPS[operation](a[p], ea[p] * SLACK, b?.[q], eb?.[q] * SLACK);
      value[i] = c;
      error[i] = e + (ROUNDED.has(operation) ? UNIT * Math.abs(c) : 0);
    }
  }
}

// The same without errors, of the three operations of polynomials.
function values(operation, n, value, a, b) {
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
const most = (row) => row.reduce((a, b) => Math.max(a, Math.abs(b)), 0);

// Whether a step varies across (1), upwards (2), both (3), or not at all (0).
function varying(steps, [across, upwards]) {
  const kinds = [];
  for (const [operation, a, b] of steps) {
    if (operation === "name") kinds.push(a === across ? 1 : a === upwards ? 2 : 0);
    else if (operation === "number") kinds.push(0);
    else kinds.push(kinds[a] | (operation === "power" || b === undefined ? 0 : kinds[b]));
  }
  return kinds;
}

// The results of a program over the rows of a picture, each with its error; or, quickly, with one for all.
export class Rows {
  constructor(steps, axes, width) {
    this.steps = steps;
    this.kinds = varying(steps, axes);
    const room = () => this.kinds.map((kind) => new Float64Array(kind & 1 ? width : 1));
    this.values = room();
    this.errors = room();
    this.polynomial = steps.every(([operation], i) => this.kinds[i] < 2 || operation === "name" || POLYNOMIAL.has(operation));
  }

  // What does not vary upwards, where names have these numbers, an array that across; and the one error for all.
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
      else if (POLYNOMIAL.has(operation)) {
        const product = operation === "multiply";
        sizes[i] = product ? (sizes[a] + bounds[a]) * (sizes[b] + bounds[b]) : sizes[a] + sizes[b];
        bounds[i] = (product ? STEPS.multiply(sizes[a], bounds[a], sizes[b], bounds[b])[1] : bounds[a] + bounds[b])
          + UNIT * sizes[i];
      }
    });
  }

  // The rest, in the row where the name upwards is y, with an error of each or without.
  row(y, errors) {
    this.y = y;
    this.take((kind) => kind > 1, errors);
  }

  take(wanted, errors = true) {
    this.steps.forEach(([operation, a, b], i) => {
      if (!wanted(this.kinds[i])) return;
      const value = this.values[i], error = this.errors[i];
      if (operation === "number" || operation === "name") {
        const given = operation === "number" ? a : this.kinds[i] === 2 ? this.y : this.numbers[a];
        for (let n = 0; n < value.length; n++) {
          value[n] = given[n] ?? given;
          error[n] = UNIT * Math.abs(value[n]);
        }
      } else if (!errors) {
        values(operation, value.length, value, this.values[a], this.values[b]);
      } else if (operation === "power") {
        over(operation, value.length, value, error, this.values[a], this.errors[a], [b], [0]);
      } else {
        over(operation, value.length, value, error, this.values[a], this.errors[a], this.values[b], this.errors[b]);
      }
    });
  }
}

// Results at numbers, without their errors. A motion runs a program ten thousand times in a second, so that its steps
// are told apart by whole numbers.
const CODES = ["add", "subtract", "multiply", "divide", "negative", "power"];

export function compiled({ steps, results }) {
  const values = new Float64Array(steps.length), named = steps.flatMap(([operation, name], i) =>
    operation === "name" ? [[i, name]] : []);
  steps.forEach(([operation, a], i) => { if (operation === "number") values[i] = a; });
  const rest = steps.map(([operation, a, b], i) => [i, operation, a, b]).filter(([, operation]) =>
    operation !== "name" && operation !== "number");
  const functions = rest.map(([, operation]) => Math[operation]);
  const codes = Int32Array.from(rest, ([, operation]) => CODES.indexOf(operation));
  const [to, left, right] = [0, 2, 3].map((n) => Float64Array.from(rest, (step) => step[n] ?? 0));
  return (numbers) => {
    for (const [i, name] of named) values[i] = numbers[name];
    for (let n = 0; n < codes.length; n++) {
      const a = values[left[n]], b = right[n];
      switch (codes[n]) {
        case 0: values[to[n]] = a + values[b]; break;
        case 1: values[to[n]] = a - values[b]; break;
        case 2: values[to[n]] = a * values[b]; break;
        case 3: values[to[n]] = a / values[b]; break;
        case 4: values[to[n]] = -a; break;
        case 5: values[to[n]] = a ** b; break;
        default: values[to[n]] = functions[n](a);
      }
    }
    return results.map((place) => values[place]);
  };
}
