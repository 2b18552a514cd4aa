// Programs of the library, as programs.py writes them, at numbers: results without their errors.

// A motion runs a program ten thousand times in a second, so that its steps are told apart by whole numbers.
const CODES = ["add", "subtract", "multiply", "divide", "negative", "power"];

/**
 * @param {{ steps: any[][], results: number[] }} program
 * @returns {(numbers: Record<string, number>) => number[]}
 */
export function compiled({ steps, results }) {
  const values = Float64Array.from(steps, ([operation, a]) => operation === "number" ? a : 0);
  /** @param {string} wanted */
  const places = (wanted) => [...steps.keys()].filter((place) => steps[place][0] === wanted);
  const named = places("name").map((place) => ({ place, name: steps[place][1] }));
  const rest = [...steps.keys()].filter((place) => !["name", "number"].includes(steps[place][0]));
  const codes = Int32Array.from(rest, (place) => CODES.indexOf(steps[place][0]));
  const left = Int32Array.from(rest, (place) => steps[place][1]);
  const right = Float64Array.from(rest, (place) => steps[place][2] ?? 0);
  /** @type {((x: number) => number)[]} */
  const functions = rest.map((place) => Reflect.get(Math, steps[place][0]));
  return (numbers) => {
    for (const { place, name } of named) values[place] = numbers[name];
    for (let n = 0; n < codes.length; n++) {
      const a = values[left[n]], b = right[n], to = rest[n];
      switch (codes[n]) {
        case 0: values[to] = a + values[b]; break;
        case 1: values[to] = a - values[b]; break;
        case 2: values[to] = a * values[b]; break;
        case 3: values[to] = a / values[b]; break;
        case 4: values[to] = -a; break;
        case 5: values[to] = a ** b; break;
        default: values[to] = functions[n](a);
      }
    }
    return results.map((place) => values[place]);
  };
}
