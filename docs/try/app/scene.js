// What the page asks: what is typed, picked and set. It is the table of a scene file, and a link.
import { asGiven, given, MADE } from "./made.js";

/**
 * What is asked. Any name may be that of a number, constructor and __proto__ too, so that the tables of names have no
 * names of their own.
 * @typedef {object} Asked
 * @property {Record<string, string>} texts the fields of the form, as they are typed
 * @property {string} equilibrium the one that is picked; "" for the first that the library offers
 * @property {string} spin the name by which the spin is given
 * @property {Record<string, string>} made what the equilibrium is made with, by its kind
 * @property {Record<string, string>} values numbers by their names, as they are typed
 * @property {string[]} axes the names across and upwards of the chart
 * @property {Map<string, import("../views/scales.js").Scale>} scales of each name that of its slider and its axis
 * @property {Record<string, string[]>} ends from where to where a link says that they go
 * @property {Record<string, boolean>} open whether what folds is open, by the question that it asks
 * @property {string} copying what is to be copied; "" if nothing is
 * @property {string} show lecture or embed; "" for the whole page
 * @property {string} push by how much the motion is turned out of the equilibrium, in rad
 */

/** @typedef {Record<string, any>} Table the keys of a scene file */

export const TEXTS = ["potential", "orbit", "inertia", "gyrostatic_momentum"];
const PLAIN = /^-?[\d.]+([*/][\d.]+)*$/;

/** @param {string} text */
const entries = (text) => text.split(",").map((entry) => entry.trim());
/** @param {string} text */
const list = (text) => text.includes(";") ? text.split(";").map(entries) : entries(text);
/** @param {any[]} value */
const listed = (value) => value.map((row) => [row].flat().join(", ")).join(Array.isArray(value[0]) ? "; " : ", ");

/** @type {(values?: Record<string, any>) => any} */
const named = (values = {}) => Object.assign(Object.create(null), values);

/** @returns {Asked} what is asked before anything is */
export const nothing = () => ({ texts: {}, equilibrium: "", spin: "pi3_0", made: {}, values: named(), axes: ["", ""],
  scales: new Map(), ends: named(), open: {}, copying: "", show: "", push: "0.05" });

/**
 * The parts of what is asked that a link or an example says; the library reads them as if they were typed.
 * @param {Table} table
 * @returns {Partial<Asked>}
 */
export function taken(table) {
  return {
    texts: { potential: table.potential ?? "U(k3)", orbit: asGiven(table.orbit),
      inertia: listed(table.inertia ?? ["I1", "I1", "I3"]),
      gyrostatic_momentum: listed(table.gyrostatic_momentum ?? ["0", "0", "l"]) },
    equilibrium: table.point ? "point" : table.equilibrium ?? "",
    made: Object.fromEntries(Object.keys(MADE).filter((name) => name in table)
      .map((name) => [name, asGiven(table[name])])),
    spin: table.spin ?? "pi3_0", values: named(table.values), scales: new Map(),
    ends: named() };
}

/**
 * The scene without numbers.
 * @param {Asked} asked
 * @returns {Table}
 */
export function scene(asked) {
  const { texts, spin } = asked;
  /** @type {Table} */
  const table = { inertia: list(texts.inertia), gyrostatic_momentum: list(texts.gyrostatic_momentum), spin };
  for (const name of ["potential", "orbit"]) if (texts[name].trim()) table[name] = texts[name];
  return Object.assign(table, given(asked));
}

/**
 * The same spin by its momentum, or by its rate: pi3_0 = I3 omega3_0.
 * @param {Asked} asked
 */
export function spun({ values, spin }) {
  const { I3, omega3_0: rate, pi3_0: momentum } = values;
  /** @param {string[]} texts */
  const plain = (...texts) => texts.every((text) => PLAIN.test(text));
  if (rate === `${momentum}/${I3}` || momentum === `${rate}*${I3}`) return;
  if (spin === "omega3_0" && plain(momentum, I3)) values.omega3_0 = `${momentum}/${I3}`;
  if (spin === "pi3_0" && plain(rate, I3)) values.pi3_0 = `${rate}*${I3}`;
}

/**
 * The number of the example whose scene this is, whatever its values; -1 if there is none.
 * @param {Table} table
 * @param {{ scene: Table }[]} examples
 */
export const numbered = (table, examples) =>
  examples.findIndex((example) => described(example.scene) === described(table));

/** @param {Table} table */
function described({ potential, orbit, inertia, gyrostatic_momentum, equilibrium, spin, ...made }) {
  return JSON.stringify([potential, asGiven(orbit), asGiven(inertia), asGiven(gyrostatic_momentum), equilibrium,
    spin ?? "pi3_0", ...Object.keys(MADE).map((name) => asGiven(made[name]))]);
}

/**
 * The scene in one line, as a person reads it.
 * @param {Asked} asked
 */
export function line({ texts, equilibrium }) {
  const { potential, orbit, inertia, gyrostatic_momentum: rotor } = texts, field = potential.trim();
  const tensor = inertia.includes(";") ? `I = [${inertia}]` : `I = (${inertia})`;
  const parts = [field && field !== "none" ? `U = ${field}` : orbit.trim() ? "" : "no field",
    orbit.trim() && `circular orbit, ${orbit}`, tensor,
    /[^0, ]/.test(rotor) ? `l = (${rotor})` : "no rotor", equilibrium];
  return parts.filter(Boolean).join("  ·  ");
}

/**
 * A link that restores what is on the page.
 * @param {Asked} asked
 */
export function link(asked) {
  const pairs = TEXTS.map((name) => [name, asked.texts[name]]);
  pairs.push(...Object.entries(given(asked)).map(([name, value]) => [name, asGiven(value)]));
  pairs.push(["axes", asked.axes.join()], ["spin", asked.spin],
    ...asked.axes.flatMap((name) => asked.scales.get(name) ?? [])
      .map(({ of, ends }) => ["ends", `${of.name}=${ends}`]),
    ...Object.entries(asked.values).map(([name, text]) => ["set", `${name}=${text}`]));
  if (asked.show) pairs.push(["show", asked.show]);
  return `#${new URLSearchParams(pairs)}`;
}

/**
 * The table of such a link, the axes of its chart, their ends, and how the page is shown; null of an address without a scene.
 * @param {string} address what stands behind its #
 */
export function linked(address) {
  const hash = new URLSearchParams(address);
  if (!hash.has("potential")) return null;
  const [values, ends] = ["set", "ends"].map((key) => hash.getAll(key)
    .map((text) => [text.split("=", 1)[0], text.slice(text.indexOf("=") + 1)]));
  /** @type {Table} */
  const table = { potential: hash.get("potential"), values: Object.fromEntries(values) };
  for (const name of ["inertia", "gyrostatic_momentum"]) if (hash.has(name)) table[name] = list(hash.get(name) ?? "");
  for (const name of ["equilibrium", "spin", "orbit", ...Object.keys(MADE)]) if (hash.get(name)) table[name] = hash.get(name);
  return { table, axes: (hash.get("axes") ?? "").split(",").filter(Boolean), show: hash.get("show") ?? "",
    ends: named(Object.fromEntries(ends.map(([name, text]) => [name, text.split(",")])
      .filter(([, [from, to]]) => Number(from) < Number(to)))) };
}
