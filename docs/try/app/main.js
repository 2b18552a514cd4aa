// The page: what is typed and picked is the question; every card shows its answer, or is marked until it has come.
import { Analyser } from "./analyser.js";
import { Card } from "./card.js";
import { Chart } from "../views/chart.js";
import { making } from "./made.js";
import { Nearby } from "../views/motion.js";
import { lost, notice, reload } from "./notices.js";
import { heard, possible } from "./numbers.js";
import { element, placed, shown, sliders, unstyled, verdict, word } from "../views/blocks.js";
import { filled, link, linked, scene, spun, state, TEXTS } from "./scene.js";

const STEPS = ["interpreter", "packages", "library", "ready"];
const SAID = { interpreter: "Python is loading", packages: "SymPy and python-flint are loading",
  library: "the library is loading", ready: "ready" };
const PAUSE = 300;                                      // milliseconds after a key
const at = (id) => document.getElementById(id);

at("unstarted").remove();
window.onerror = (message) => notice("page", `This page failed (${message}).`, ...reload);
window.onunhandledrejection = ({ reason }) => window.onerror(reason?.message ?? reason);

const analyser = new Analyser(told);
const ask = (want, table, more) => analyser.ask(want, table, more);
const answers = (want, draw) => new Card((table) => ask(want, table), draw, update);
const scenes = answers("analysed", analysed), verdicts = answers("decided", decided);
const windows = answers("opened", (found) => shown(at("between"), found ?? {}));
const derivations = answers("derived", (found) => shown(at("blocks"), found ?? {}));
const copies = answers("copied", (found) => copied(found?.[copying], found?.error));
const chart = new Chart(at("charted"), ask, set, update);
const nearby = new Nearby(at("nearby"), ask, changed, update);
const SECTIONS = document.querySelectorAll("main section");
let examples = [], copying = "";

// Of each place the card whose answer it shows.
const PLACES = { equilibria: scenes, values: scenes, error: scenes, conditions: scenes, place: scenes, opened: scenes,
  verdict: verdicts, wrong: verdicts, reasons: verdicts, here: verdicts, between: windows, blocks: derivations,
  picture: chart, path: nearby };

// Every card, from what the page asks now; if something is typed, after a pause.
function update(pause) {
  scenes.follow(scene(), pause);
  const known = scenes.waiting ? undefined : scenes.answer.error ? null : scene();
  const values = Object.fromEntries((scenes.answer?.names ?? []).map(({ name }) => [name, state.values[name]]));
  const whole = known && { ...known, values };
  verdicts.follow(whole);
  windows.follow(at("opened").open && !at("opened").hidden ? whole : null);
  derivations.follow(at("derivation").open ? known : null);
  copies.follow(copying && copying !== "link" ? whole : null);
  const value = (name) => possible(name, state.values[name]);
  chart.follow(known, values, value, verdicts.waiting);
  nearby.follow(known, Object.keys(values), state.values, value, verdicts.waiting);
  const { answer, question } = verdicts;
  at("here").textContent = answer?.verdict
    ? `${chart.axes.map((name) => `${name} = ${question.values[name]}`).join(", ")}: ${word(answer.verdict)}` : "";
  for (const [id, card] of Object.entries(PLACES)) marked(at(id), card.waiting);
  for (const section of SECTIONS) section.classList.toggle("waiting", Boolean(section.querySelector("[aria-busy=true]")));
  document.body.ariaBusy = String([scenes, verdicts, windows, derivations, copies].some((card) => card.waiting));
}

// An answer to another question than the page's is gone if the scene is another, and pale if the numbers are.
function marked(place, waiting) {
  place.ariaBusy = String(waiting);
  place.style.opacity = waiting ? 0.4 : "";
  place.style.visibility = scenes.waiting && place.classList.contains("answer") ? "hidden" : "";
}

// Something is set by the visitor: what was copied is of what was there before.
function changed(pause) {
  copying = "";
  copied();
  remember();
  update(pause);
}

// Other numbers, whose fields are made again even if the scene is the one before.
function renewed() {
  scenes.forget();
  changed();
}

function told({ step, ready, failed }) {
  at("starting").hidden = Boolean(ready || failed);
  if (!failed) {
    at("progress").value = STEPS.indexOf(step ?? "ready");
    at("status").textContent = SAID[step ?? "ready"];
  }
  const why = navigator.onLine ? `${failed}). A file is not on the server, or this browser is too old for it`
    : "the network is not there). It starts again when the network is back";
  notice("library", failed && `The library could not be started (${why}. What is typed stays; the library runs on your own `
    + "machine too.", "Start it again", again);
}

function again() {
  for (const card of [scenes, verdicts, windows, derivations, copies, chart.programs, chart.edges, nearby.programs]) {
    if (card.answer?.lost) card.forget();
  }
  told({ step: STEPS[0] });
  analyser.start();
  update();
}

function analysed(found) {
  if (found.equilibria) {
    state.equilibrium = found.chosen;
    choices(found);
    making(state, found);
  } else {                                              // the list of the scene before
    for (const input of at("equilibria").querySelectorAll("input")) input.checked = input.value === state.equilibrium;
    if (state.equilibrium === "point") making(state, { made_with: "point" });             // for what is to be typed
    else if (at("made").name === "point") at("made-row").hidden = true;
  }
  at("error").textContent = found.error ?? "";
  at("derived").inert = Boolean(found.error);
  state.place = found.place;
  at("place").hidden = !found.point;
  at("opened").hidden = !found.open;
  at("derivation").hidden = Boolean(found.error);
  shown(at("point"), { blocks: found.point });
  shown(at("conditions"), { blocks: found.conditions });
  sliders(at("values"), found.names ?? [], state.values, changed);
  if (found.axes) chart.choose(found.axes);
  return scene();                                       // with the equilibrium that was chosen
}

function decided(found, question) {
  const { error = "", ...answer } = found ?? {};
  at("wrong").textContent = error;
  for (const text of at("values").querySelectorAll("[id]")) text.ariaInvalid = String(error.includes(`'${text.value}'`)
    || error.startsWith(`${text.id.slice(6)} = `));
  verdict(at("verdict"), at("reasons"), answer);
  if (!answer.doubles) return;
  heard(question.values, answer.doubles);
  placed(at("values"));
}

// A number is set by a picture.
function set(name, text) {
  const input = at(`value-${name}`);
  input.value = text;
  input.dispatchEvent(new Event("input"));
}

function choices({ equilibria, chosen }) {
  const held = at("equilibria").contains(document.activeElement);
  at("equilibria").replaceChildren(...equilibria.map(({ name, title, why }) => {
    const input = element("input", { type: "radio", name: "equilibrium", value: name, checked: name === chosen });
    input.onchange = () => {
      if (name === "point" && !state.made.point) state.made.point = state.place ?? "";
      state.equilibrium = name;
      changed();
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
    history.replaceState(null, "", link(chart.axes));
  }, 400);
}

function copy(kind) {
  copying = kind;
  if (kind === "link") copied(new URL(link(chart.axes), location).href);
  else if (copies.answer && !copies.waiting) copied(copies.answer[kind], copies.answer.error);
  update();
}

// What is to be copied; nothing; or why there is nothing.
function copied(text, error = "") {
  at("copied").value = text ?? "";
  at("copied").hidden = !text;
  at("said").textContent = error;
  if (!text) return;
  at("copied").rows = Math.min(text.split("\n").length, 14);
  at("copied").scrollIntoView({ block: "nearest" });
  const done = `${document.querySelector(`[data-copy=${copying}]`).textContent}: copied`;
  navigator.clipboard?.writeText(text).then(() => { if (at("copied").value === text) at("said").textContent = done; }, () => {});
}

for (const name of [...TEXTS, "made"]) {
  at(name).oninput = () => {
    if (name === "made") state.made[at(name).name] = at(name).value;
    at("example").selectedIndex = -1;                   // what is typed is another scene
    at("source").textContent = "";
    changed(PAUSE);
  };
}
at("opened").ontoggle = at("derivation").ontoggle = () => update();
at("ask").onsubmit = () => false;
at("spin").onchange = () => { state.spin = at("spin").value; spun(); renewed(); };
at("example").onchange = () => { filled(examples[at("example").value].scene, examples); renewed(); };
for (const button of document.querySelectorAll("[data-copy]")) button.onclick = () => copy(button.dataset.copy);

// What the address says, or the first example.
function restore() {
  const found = linked();
  chart.wanted = found?.axes ?? [];
  filled(found?.table ?? examples[0]?.scene ?? {}, examples);
  renewed();
}

// What the page can do without, and says so.
function checked() {
  if (!globalThis.katex) lost("katex/katex.min.js", "formulas stand here as they are written in LaTeX.");
  for (const link of document.querySelectorAll("link[rel=stylesheet]")) {
    if (arrived(link)) continue;
    const name = link.getAttribute("href"), formulas = name.startsWith("katex");
    if (formulas) unstyled();
    lost(name, formulas ? "the browser sets the formulas." : "the page is plain, and has no chart.");
  }
}

// Whether a style has come; the rules of one that has not are none, or cannot be asked for.
function arrived({ sheet }) {
  try {
    return sheet.cssRules.length > 0;
  } catch {
    return false;
  }
}

document.fonts.onloadingerror = () => lost("A font", "formulas may look odd.");
if (document.readyState === "complete") checked();
else window.onload = checked;
window.onhashchange = restore;
window.ononline = () => { if (analyser.lost) again(); };
try {
  const response = await fetch("examples.json");
  if (!response.ok) throw new Error(response.status);
  examples = await response.json();
} catch {
  lost("examples.json", "there is no example to pick; all else works.");
}
at("example").append(...examples.map(({ title }, n) => element("option", { value: n }, title)));
restore();
