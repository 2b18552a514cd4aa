// The scene that the fields of the page say, as the table of a scene file, and as a link.
import { asGiven, given, MADE } from "./made.js";

export const TEXTS = ["potential", "orbit", "inertia", "gyrostatic_momentum"];
const PLAIN = /^-?[\d.]+([*/][\d.]+)*$/;
const at = (id) => document.getElementById(id);
const entries = (text) => text.split(",").map((entry) => entry.trim());
const list = (text) => text.includes(";") ? text.split(";").map(entries) : entries(text);
const listed = (value) => value.map((row) => [row].flat().join(", ")).join(Array.isArray(value[0]) ? "; " : ", ");

// Beside the fields: the equilibrium, its spin, what it is made with, numbers by their names. Any name is one,
// constructor and __proto__ too, so that these objects have no names of their own.
const named = (values = {}) => Object.assign(Object.create(null), values);
export const state = { equilibrium: "", spin: "", made: {}, values: named() };

// Without numbers.
export function scene() {
  const table = { inertia: list(at("inertia").value),
    gyrostatic_momentum: list(at("gyrostatic_momentum").value), spin: state.spin };
  for (const name of ["potential", "orbit"]) if (at(name).value.trim()) table[name] = at(name).value;
  return Object.assign(table, given(state));
}

// The same spin by its momentum, or by its rate: pi3_0 = I3 omega3_0.
export function spun() {
  const { values } = state, { I3, omega3_0: rate, pi3_0: momentum } = values;
  const plain = (...texts) => texts.every((text) => PLAIN.test(text));
  if (rate === `${momentum}/${I3}` || momentum === `${rate}*${I3}`) return;
  if (state.spin === "omega3_0" && plain(momentum, I3)) values.omega3_0 = `${momentum}/${I3}`;
  if (state.spin === "pi3_0" && plain(rate, I3)) values.pi3_0 = `${rate}*${I3}`;
}

// What a link or an example says, into the fields; the library reads them as if they were typed.
export function filled(table, examples) {
  at("potential").value = table.potential ?? "U(k3)";
  at("orbit").value = asGiven(table.orbit);
  at("inertia").value = listed(table.inertia ?? ["I1", "I1", "I3"]);
  at("gyrostatic_momentum").value = listed(table.gyrostatic_momentum ?? ["0", "0", "l"]);
  state.equilibrium = table.point ? "point" : table.equilibrium ?? "";
  state.made = Object.fromEntries(Object.keys(MADE).filter((name) => name in table)
    .map((name) => [name, asGiven(table[name])]));
  state.spin = at("spin").value = table.spin ?? "pi3_0";
  state.values = named(table.values);
  at("example").selectedIndex = examples.findIndex((example) => described(example.scene) === described(table));
  at("source").textContent = examples[at("example").selectedIndex]?.source ?? "";
}

// A scene without its values, to tell whether two are the same.
const described = ({ potential, orbit, inertia, gyrostatic_momentum, equilibrium, spin, ...made }) => JSON.stringify([potential,
  asGiven(orbit), asGiven(inertia), asGiven(gyrostatic_momentum), equilibrium, spin ?? "pi3_0",
  ...Object.keys(MADE).map((name) => asGiven(made[name]))]);

// A link that restores what is on the page.
export function link(axes) {
  const pairs = TEXTS.map((name) => [name, at(name).value]);
  pairs.push(...Object.entries(given(state)));
  pairs.push(["axes", axes.join()], ["spin", state.spin],
    ...Object.entries(state.values).map(([name, text]) => ["set", `${name}=${text}`]));
  return `#${new URLSearchParams(pairs)}`;
}

// The table of such a link, and the axes of its chart; null of an address without a scene.
export function linked() {
  const hash = new URLSearchParams(location.hash.slice(1));
  if (!hash.has("potential")) return null;
  const values = hash.getAll("set").map((text) => [text.split("=", 1)[0], text.slice(text.indexOf("=") + 1)]);
  const table = { potential: hash.get("potential"), values: Object.fromEntries(values) };
  for (const name of ["inertia", "gyrostatic_momentum"]) if (hash.has(name)) table[name] = list(hash.get(name));
  for (const name of ["equilibrium", "spin", "orbit", ...Object.keys(MADE)]) if (hash.get(name)) table[name] = hash.get(name);
  return { table, axes: (hash.get("axes") ?? "").split(",").filter(Boolean) };
}
