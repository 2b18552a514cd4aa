// The page: what is asked stands in `asked`, what is answered in `answers`; every view is drawn from the two.
import { say, typeset, word } from "../views/blocks.js";
import { Nearby } from "../views/body.js";
import { Chart } from "../views/chart.js";
import { fitted, placed } from "../views/sliders.js";
import { Analyser } from "./analyser.js";
import { Answers } from "./answers.js";
import { checked } from "./arrived.js";
import { cards } from "./cards.js";
import { copied } from "./copies.js";
import { Form } from "./form.js";
import { gallery } from "./gallery.js";
import { Entries } from "./history.js";
import { keep } from "./kept.js";
import { Modes } from "./modes.js";
import { lost, notice, reload } from "./notices.js";
import { heard, possible } from "./numbers.js";
import { library } from "./prepared.js";
import { progress } from "./progress.js";
import { link, linked, nothing, numbered, scene, taken } from "./scene.js";
import { Sharing } from "./sharing.js";
import { KINDS, questions } from "./state.js";

const SOON = 60;                                        // milliseconds before the boundary of a chart is asked for
/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);

const analyser = new Analyser();
if (navigator.serviceWorker?.controller) analyser.start();              // what is kept here needs no line
at("unstarted").remove();
window.onerror = (message) => notice("page", `This page failed (${message}).`, ...reload);
window.onunhandledrejection = ({ reason }) => window.onerror?.(reason?.message ?? reason);

const asked = nothing();
/** @type {Record<string, import("./answers.js").Answered>} */
const drawn = {};                                       // of each kind the answer that its card shows
/** @type {{ title: string, source: string, scene: import("./scene.js").Table }[]} */
let examples = [];
const asks = Object.fromEntries(KINDS.map((kind) => [kind, (/** @type {any} */ question) => analyser.ask(kind, question)]));
const answers = new Answers({ ...asks,
  charted: ({ scene, axes }) => analyser.ask("charted", scene, [axes]),
  edges: ({ scene, axes, ends }) => analyser.ask("edges", scene, [axes, ends]) }, update, { analysed, decided },
  library(async () => examples, (n) => json(`prepared/${n}.json`)), differed);
const form = new Form(asked, changed, picked);
const chart = new Chart(at("charted"), asked, answers, set, update);
const nearby = new Nearby(at("nearby"), asked, answers, changed, update);
const sharing = new Sharing(asked, answers, { body: nearby, chart }, update);
const modes = new Modes(asked, (by) => picked(Number(at("example").value) + by), update);
const entries = new Entries((address) => history.pushState(null, "", address),
  (address) => history.replaceState(null, "", address), () => location.hash);
const draw = cards(asked, form, changed);
const SECTIONS = document.querySelectorAll("main section");

/**
 * Of each place the kind of the answer that it shows, or the view.
 * @type {Record<string, string | { waiting: boolean }>}
 */
const PLACES = { equilibria: "analysed", values: "analysed", error: "analysed", conditions: "analysed",
  place: "analysed", opened: "analysed", verdict: "decided", wrong: "decided", reasons: "decided", here: "decided",
  survived: "survived", between: "opened", blocks: "derived", picture: chart, path: nearby };

// Every question, from what the page asks now, and every view; if something is typed, after a pause.
function update(pause = 0) {
  /** @type {Record<string, number>} */
  const pauses = { analysed: pause, edges: SOON };
  for (const kind of ["analysed", "moving"]) fitted(asked, answers.answered[kind]?.answer.names ?? []);
  for (const [kind, question] of Object.entries(questions(asked, answers, possible))) {
    answers.follow(kind, question, pauses[kind]);
  }
  for (const kind of KINDS) {
    const now = answers.answered[kind];
    if (now === drawn[kind]) continue;
    drawn[kind] = now;
    draw[kind]?.(now?.answer, now?.question);
  }
  placed(at("values"), asked);
  placed(at("more"), asked);
  const reading = answers.waiting("decided"), { answer, question } = answers.answered.decided ?? {};
  chart.follow(reading);
  nearby.follow(reading);
  say(at("here"), answer?.verdict
    ? `${asked.axes.map((name) => `${name} = ${question.values[name]}`).join(", ")}: ${word(answer.verdict)}` : "");
  entries.follow(link(asked));
  modes.follow();
  const early = KINDS.some((kind) => answers.of(kind) && answers.answered[kind].prepared);
  at("early").hidden = !early;
  document.body.classList.toggle("early", early);
  sharing.follow(mark() || early);
}

/** A library that answers otherwise than when the page was built. @param {string} kind */
function differed(kind) {
  console.error(`prepared answer differs: ${kind}`);
  notice("prepared", "An answer that was computed when this page was built was not the library's; the library's is shown.",
    ...reload);
}

// An answer to another question than the page's is gone if the scene is another, and pale if the numbers are. Whether
// there is one.
function mark() {
  let some = false;
  for (const [id, shows] of Object.entries(PLACES)) {
    const place = at(id), waiting = typeof shows === "string" ? answers.waiting(shows) : shows.waiting;
    some ||= waiting;
    place.ariaBusy = String(waiting);
    place.style.opacity = waiting ? 0.4 : "";
    place.style.visibility = answers.waiting("analysed") && place.classList.contains("answer") ? "hidden" : "";
  }
  for (const section of SECTIONS) section.classList.toggle("waiting", Boolean(section.querySelector("[aria-busy=true]")));
  document.body.ariaBusy = String(["analysed", "decided", "opened", "derived", "copied"].some((kind) => answers.waiting(kind)));
  return some;
}

/** The library names the equilibrium that it has chosen, and the axes that a chart may have. @param {any} found */
function analysed(found) {
  if (found.equilibria) asked.equilibrium = found.chosen;
  if (found.axes) chart.choose(found.axes, found.names);
  return scene(asked);
}

/** The library says the doubles of numbers that are no decimals. @param {any} found @param {any} question */
function decided(found, { values }) {
  if (found.doubles) heard(values, found.doubles);
}

// Something is set by the visitor, or typed in a field: what was copied is of what was there before.
function changed(pause = 0, field = "") {
  asked.copying = "";
  copied("");
  entries.follow(link(asked), field);
  update(pause);
}

/** An example, if there is one of this number. @param {number} n */
function picked(n) {
  if (!examples[n]) return;
  restore({ table: examples[n].scene });
  changed();
}

/**
 * Other fields and numbers, which are made again even if the scene is the one before.
 * @param {{ table: import("./scene.js").Table, axes?: string[], ends?: Record<string, [string, string]> }} found
 */
function restore({ table, axes = [], ends = {} }) {
  const example = numbered(table, examples);
  Object.assign(asked, taken(table));
  Object.assign(asked.ends, ends);
  chart.wanted = axes;
  form.fill(example, examples[example]?.source ?? "");
  answers.forget("analysed");
}

/** @param {import("./progress.js").News & { failed?: string }} news */
function told({ failed, ...news }) {
  if (news.version) return keep(news.version);
  const { share, text } = progress(news);
  nearby.spare(Boolean(news.ready || failed), share !== undefined && share < 1);
  at("starting").hidden = Boolean(news.ready || failed);
  at("progress").value = share ?? at("progress").value;
  if (!failed) at("status").textContent = text;
  const why = navigator.onLine ? `${failed}). A file is not on the server, or this browser is too old for it`
    : "the network is not there). It starts again when the network is back";
  notice("library", !failed ? "" : `The library could not be started (${why}. What is typed stays; the library runs on your own `
    + "machine too.", "Start it again", again);
}

function again() {
  for (const kind of KINDS) if (answers.answered[kind]?.answer.lost) answers.forget(kind);
  told({});
  analyser.start();
  update();
}

/** A number is set by a picture. @param {string} name @param {string} text */
function set(name, text) {
  const input = at(`value-${name}`);
  input.value = text;
  input.dispatchEvent(new Event("input"));
}

for (const [id, kind] of [["opened", "opened"], ["derivation", "derived"]]) {
  at(id).ontoggle = () => {
    asked.open[kind] = at(id).open;
    update();
  };
}

/** @param {string} address */
async function json(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(String(response.status));
  return response.json();
}

// What the address says, or the first example.
function arrive() {
  const found = linked(location.hash.slice(1)) ?? { table: examples[0]?.scene ?? {}, show: "" };
  asked.show = found.show;
  restore(found);
  entries.arrived(location.hash);
  asked.copying = "";
  copied("");
  update();
}

document.fonts.onloadingerror = () => lost("A font", "formulas may look odd.");
at("formulas").onload = typeset;
if (document.readyState === "complete") checked();
else window.onload = checked;
window.onhashchange = arrive;
window.ononline = () => { if (analyser.lost) again(); };
try {
  examples = await json("examples.json");
} catch {
  lost("examples.json", "there is no example to pick; all else works.");
}
form.list(examples);
gallery(at("gallery"), examples, picked);
arrive();
analyser.listen(told);
if (!analyser.started) setTimeout(() => analyser.start(), 50);           // milliseconds: what is prepared is seen first
