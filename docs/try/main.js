// The page: what is typed and picked goes to the analyser as the keys of a scene file; its answers are shown.
import { Analyser, LIMIT } from "./analyser.js";
import { Chart } from "./chart.js";
import { asGiven, given, MADE, making } from "./made.js";
import { Nearby } from "./motion.js";
import { element, heard, noVerdict, number, placed, shown, sliders, verdict, word } from "./page.js";

const STEPS = ["interpreter", "packages", "library", "ready"];
const SAID = { interpreter: "Python is loading", packages: "SymPy and python-flint are loading",
  library: "the library is loading", ready: "ready" };
const PLAIN = /^-?[\d.]+([*/][\d.]+)*$/;
const TEXTS = ["potential", "orbit", "inertia", "gyrostatic_momentum"];
const at = (id) => document.getElementById(id);

const state = { equilibrium: "", spin: "", made: {}, values: {} };
const analyser = new Analyser(told);
const ask = (want, more) => analyser.ask(want, scene(), more);
const chart = new Chart(at("charted"), ask, changed);
const nearby = new Nearby(at("nearby"), ask, () => state.values, number);
const examples = await (await fetch("examples.json")).json();

function told({ step, ready, ended, broken, failed }) {
  if (step || ready) {
    at("progress").value = STEPS.indexOf(step ?? "ready");
    at("status").textContent = SAID[step ?? "ready"];
    at("starting").hidden = Boolean(ready);
  }
  if (ended) {
    notice(`This took longer than ${LIMIT} s and was ended; the library starts again. Write it more simply, or `
      + "use the library on your own machine, where nothing ends it.");
  }
  if (broken) notice(`The computation failed (${broken}); the library starts again. Write it more simply.`);
  if (failed) {
    at("starting").hidden = true;
    document.body.ariaBusy = "false";
    notice(`The library could not be started (${failed}): its files are not beside this page, or the browser is `
      + "too old. Build them with docs/try/build.py.");
  }
}

// aria-busy from the first key to the last answer.
let open = 0;
function busy(more) {
  open += more;
  document.body.ariaBusy = String(open > 0);
}

async function working(what) {
  busy(1);
  try {
    await what();
  } finally {
    busy(-1);
  }
}

function notice(text) {
  at("notice").textContent = text;
  at("notice").hidden = !text;
}

const entries = (text) => text.split(",").map((entry) => entry.trim());
const list = (text) => text.includes(";") ? text.split(";").map(entries) : entries(text);
const listed = (value) => value.map((row) => [row].flat().join(", ")).join(Array.isArray(value[0]) ? "; " : ", ");

function scene() {
  const table = { inertia: list(at("inertia").value),
    gyrostatic_momentum: list(at("gyrostatic_momentum").value), spin: state.spin };
  for (const name of ["potential", "orbit"]) if (at(name).value.trim()) table[name] = at(name).value;
  Object.assign(table, given(state));
  return { ...table, values: { ...state.values } };
}

// What a link or an example says, into the fields; the library reads them as if they were typed.
function filled(table) {
  at("potential").value = table.potential ?? "U(k3)";
  at("orbit").value = asGiven(table.orbit);
  at("inertia").value = listed(table.inertia ?? ["I1", "I1", "I3"]);
  at("gyrostatic_momentum").value = listed(table.gyrostatic_momentum ?? ["0", "0", "l"]);
  state.equilibrium = table.point ? "point" : table.equilibrium ?? "";
  state.made = Object.fromEntries(Object.keys(MADE).filter((name) => name in table)
    .map((name) => [name, asGiven(table[name])]));
  state.spin = at("spin").value = table.spin ?? "pi3_0";
  state.values = { ...table.values };
  at("example").selectedIndex = examples.findIndex((example) => described(example.scene) === described(table));
  at("source").textContent = examples[at("example").selectedIndex]?.source ?? "";
}

// A scene without its values, to tell whether two are the same.
const described = ({ potential, orbit, inertia, gyrostatic_momentum, equilibrium, spin, ...made }) => JSON.stringify([potential,
  asGiven(orbit), asGiven(inertia), asGiven(gyrostatic_momentum), equilibrium, spin ?? "pi3_0",
  ...Object.keys(MADE).map((name) => asGiven(made[name]))]);

const analyse = () => working(async () => {
  remember();
  const found = await analyser.ask("analysed", scene());
  if (!found) return;
  if (found.equilibria) {
    state.equilibrium = found.chosen;
    choices(found);
    making(state, found);
  } else if (state.equilibrium === "point") {
    making(state, { made_with: "point" });              // for what is to be typed
  }
  refused(found.error);
  if (found.error) return;
  state.place = found.place;
  at("place").hidden = !found.point;
  shown(at("point"), found.point ?? []);
  shown(at("conditions"), found.conditions ?? []);
  at("opened").hidden = !found.open;
  chart.leave();
  nearby.leave();
  sliders(at("values"), found.names, state.values, follow);
  await decide();
  chart.choose(found.axes, (name) => number(state.values[name] ?? ""));
  nearby.choose(found.names.map(({ name }) => name));
  if (at("derivation").open) await derive();
});

// Pictures follow at once, the verdict when it is there.
function follow() {
  chart.follow();
  nearby.restart();
  decide();
}

// The same spin by its momentum, or by its rate: pi3_0 = I3 omega3_0.
function spun(values) {
  const { I3, omega3_0: rate, pi3_0: momentum } = values;
  const plain = (...texts) => texts.every((text) => PLAIN.test(text));
  if (rate === `${momentum}/${I3}` || momentum === `${rate}*${I3}`) return;
  if (state.spin === "omega3_0" && plain(momentum, I3)) values.omega3_0 = `${momentum}/${I3}`;
  if (state.spin === "pi3_0" && plain(rate, I3)) values.pi3_0 = `${rate}*${I3}`;
}

// A number is set by a picture.
function changed(name, text) {
  const input = at(`value-${name}`);
  input.value = text;
  input.dispatchEvent(new Event("input"));
}

const decide = () => working(async () => {
  remember();
  const asked = scene(), found = await analyser.ask("decided", asked);
  if (!found) return;
  wrong(found.error);
  if (found.error) return;
  verdict(at("verdict"), at("reasons"), found);
  if (found.verdict) chart.say(asked.values, word(found.verdict));
  if (heard(asked.values, found.doubles)) {
    placed(at("values"));
    chart.follow();
    nearby.restart();
  }
  if (at("opened").open && !at("opened").hidden) await openBetween();
});

const openBetween = () => working(async () => {
  const found = await analyser.ask("opened", scene());
  if (found) shown(at("between"), found.error ? [{ sentence: [{ text: found.error }] }] : found.blocks);
});

const derive = () => working(async () => {
  const found = await analyser.ask("derived", scene());
  if (found && !found.error) shown(at("blocks"), found.blocks);
});

function refused(error = "") {
  at("error").textContent = error;
  at("derived").inert = Boolean(error);
  if (error) noVerdict(at("verdict"), at("reasons"));
}

// Of numbers; those that are none are marked.
function wrong(error = "") {
  at("wrong").textContent = error;
  for (const text of at("values").querySelectorAll("[id]")) text.ariaInvalid = String(error.includes(`'${text.value}'`)
    || error.startsWith(`${text.id.slice(6)} = `));
  if (error) noVerdict(at("verdict"), at("reasons"));
}

function choices({ equilibria, chosen }) {
  const held = at("equilibria").contains(document.activeElement);
  at("equilibria").replaceChildren(...equilibria.map(({ name, title, why }) => {
    const input = element("input", { type: "radio", name: "equilibrium", value: name, checked: name === chosen });
    input.onchange = () => {
      if (name === "point" && !state.made.point) state.made.point = state.place ?? "";
      state.equilibrium = name;
      analyse();
    };
    return element("label", { title: why, className: why ? "none" : "" }, input, ` ${name} `,
      element("small", {}, why ? "not here" : title === `rotation about ${name}` ? "" : title));
  }));
  if (held) at("equilibria").querySelector(":checked").focus();
}

// The address is a link that restores what is on the page. Browsers take a new one some hundred times in half a
// minute, then refuse; a slider moves oftener.
let remembering;
function remember() {
  remembering ??= setTimeout(() => {
    remembering = undefined;
    history.replaceState(null, "", `#${restoring()}`);
  }, 400);
}

function restoring() {
  const table = scene(), pairs = TEXTS.map((name) => [name, at(name).value]);
  pairs.push(...Object.entries(given(state)));
  pairs.push(["axes", chart.axes.join()], ["spin", table.spin], ...Object.entries(table.values).map(([name, text]) => ["set", `${name}=${text}`]));
  return new URLSearchParams(pairs);
}

function restored() {
  const hash = new URLSearchParams(location.hash.slice(1));
  if (!hash.has("potential")) return examples[0].scene;
  const values = hash.getAll("set").map((text) => [text.split("=", 1)[0], text.slice(text.indexOf("=") + 1)]);
  const table = { potential: hash.get("potential"), values: Object.fromEntries(values) };
  for (const name of ["inertia", "gyrostatic_momentum"]) if (hash.has(name)) table[name] = list(hash.get(name));
  for (const name of ["equilibrium", "spin", "orbit", ...Object.keys(MADE)]) if (hash.get(name)) table[name] = hash.get(name);
  if (hash.get("axes")) chart.wanted = hash.get("axes").split(",");
  return table;
}

const copy = (kind) => working(async () => {
  const text = kind === "link" ? new URL(`#${restoring()}`, location).href : (await analyser.ask("copied", scene()))?.[kind];
  if (!text) return;
  at("copied").value = text;
  at("copied").hidden = false;
  at("copied").rows = Math.min(text.split("\n").length, 14);
  at("copied").scrollIntoView({ block: "nearest" });
  const done = `${document.querySelector(`[data-copy=${kind}]`).textContent}: copied`;
  at("said").textContent = await navigator.clipboard?.writeText(text).then(() => done, () => "") ?? "";
});

let typed;
for (const name of [...TEXTS, "made"]) {
  at(name).oninput = () => {
    if (name === "made") state.made[at(name).name] = at(name).value;
    at("example").selectedIndex = -1;                   // what is typed is another scene
    at("source").textContent = "";
    if (!typed) busy(1);
    clearTimeout(typed);
    typed = setTimeout(() => { typed = undefined; notice(""); analyse(); busy(-1); }, 300);
  };
}
at("opened").ontoggle = () => { if (at("opened").open) openBetween(); };
at("ask").onsubmit = () => false;
at("spin").onchange = () => { state.spin = at("spin").value; spun(state.values); analyse(); };
at("derivation").ontoggle = () => { if (at("derivation").open) derive(); };
at("example").append(...examples.map(({ title }, n) => element("option", { value: n }, title)));
at("example").onchange = () => { filled(examples[at("example").value].scene); notice(""); analyse(); };
for (const button of document.querySelectorAll("[data-copy]")) button.onclick = () => copy(button.dataset.copy);
window.onhashchange = () => {
  filled(restored());
  analyse();
};
filled(restored());
analyse();
