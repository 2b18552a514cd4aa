// Numbers as the library reads them: what is typed stays a text, and pictures need the double nearest to it.

// A decimal, or a fraction whose parts are doubles, in the library's grammar: it has no 0x10 and no Infinity.
const PLAIN = /^ *[-+]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|\d{1,15} *\/ *\d{1,15}) *$/;
/** @type {Map<string, number>} */
const said = new Map();

/**
 * The double nearest to a text; of another text than 1.25 or 1/2 what the library has said of it under this name: 3 rpm
 * is a rate, and no moment of inertia. NaN of what is none.
 * @param {string} name
 */
export function number(name, text = "") {
  if (!PLAIN.test(text)) return said.get(`${name} = ${text}`) ?? NaN;
  const [above, below = "1"] = text.split("/");
  return Number(above) / Number(below);
}

/**
 * What the library says of texts.
 * @param {Record<string, string>} values
 * @param {Record<string, number>} doubles
 */
export function heard(values, doubles) {
  for (const [name, value] of Object.entries(doubles)) said.set(`${name} = ${values[name]}`, value);
}

/**
 * Names that the library takes as positive; a number of theirs that is not is none.
 * @type {Set<string>}
 */
export const positive = new Set();
/** @type {(name: string, text?: string) => number} */
export const possible = (name, text) => {
  const value = number(name, text);
  return positive.has(name) && value <= 0 ? NaN : value;
};
