// What is taken from the page: texts to copy, a picture of what is seen, paper. All wait for the answers.
import { paint } from "../views/body-picture.js";
import { LIGHT } from "../views/colours.js";
import { composed, named, svg } from "../views/picture.js";
import { escaped } from "../views/svg.js";
import { copied } from "./copies.js";
import { line, link } from "./scene.js";

/** @typedef {import("./scene.js").Asked} Asked */

/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);
/** @param {string} selector @returns {any[]} */
const all = (selector) => [...document.querySelectorAll(selector)];
const PAPER = ["svg", "png", "print"], SHARP = 2;        // pixels of a picture for each of its units
const SIZE = 400;                                       // of a body in it
const ACROSS = 56;                                      // letters of print, each as wide as it is high, on A4

/** The name of the scene, "" of one that is no example. */
export const title = () => document.querySelector("#example option:checked:enabled")?.textContent ?? "";

/** The whole address of a mode of the page. @param {Asked} asked @param {string} show */
export const address = (asked, show) => new URL(link({ ...asked, show }), location.href).href;

/** With this a page of another site shows the scene. @param {Asked} asked */
const embedded = (asked) => `<iframe src="${escaped(address(asked, "embed"))}" width="720" height="420" `
  + `title="${escaped(title() || line(asked))} (gyrostat)" loading="lazy" `
  + 'style="border: 1px solid #d0d7de"></iframe>';

/** @param {import("../views/picture.js").Seen} seen */
function painted(seen) {
  const { width, height, draw } = composed(seen), canvas = document.createElement("canvas");
  canvas.width = SHARP * width;
  canvas.height = SHARP * height;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.scale(SHARP, SHARP);
  draw(context);
  return canvas;
}

export class Sharing {
  /**
   * @param {Asked} asked
   * @param {import("./answers.js").Answers} answers
   * @param {{ body: import("../views/body.js").Nearby, chart: import("../views/chart.js").Chart }} views
   * @param {() => void} update
   */
  constructor(asked, answers, views, update) {
    this.asked = asked;
    this.answers = answers;
    this.views = views;
    this.waiting = true;
    /** @type {any} */
    this.given = null;
    for (const button of all("[data-copy]")) {
      button.onclick = () => {
        asked.copying = button.dataset.copy;
        this.given = null;
        update();
      };
    }
    window.onbeforeprint = () => this.paper();
  }

  /** Gives what is asked for when it has come. @param {boolean} waiting whether something is marked */
  follow(waiting) {
    const { asked, answers } = this, kind = asked.copying;
    this.waiting = waiting;
    if (PAPER.includes(kind)) {
      if (!waiting) this.take(kind);
    } else if (kind) {
      const here = { link: () => address(asked, ""), embed: () => embedded(asked) }[kind];
      const found = here ? { [kind]: here() } : answers.of("copied");
      const given = found && (found[kind] ?? found.error);
      if (!found || given === this.given) return;
      this.given = given;
      copied(kind, found[kind], found.error);
    }
  }

  /** A file of what is seen, or paper. @param {string} kind */
  async take(kind) {
    this.asked.copying = "";
    if (kind === "print") return print();
    const seen = this.seen();
    if (!seen.verdict.text) return copied(kind, "", "There is no picture: the scene has no answer.");
    const data = kind === "svg" ? svg(seen) : painted(seen);
    const file = typeof data === "string" ? new Blob([data], { type: "image/svg+xml" })
      : await new Promise((done) => { data.toBlob(done); });
    const link = document.createElement("a");
    link.href = URL.createObjectURL(file);
    link.download = named(seen, kind);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    copied(kind, "", `${link.download} is saved`);
  }

  /** What is seen, in the colours of the light theme, whatever that of the page: for paper. */
  seen() {
    const { style } = document.documentElement;
    style.colorScheme = "light";
    try {
      return this.lit();
    } finally {
      style.colorScheme = "";
      this.views.chart.inks();
    }
  }

  /** @returns {import("../views/picture.js").Seen} */
  lit() {
    const { views: { body: { picture }, chart }, answers: { answered: { decided } } } = this;
    /** @param {Element} one */
    const text = (one) => one.textContent?.trim() ?? "";
    const [badge] = all("#verdict .badge"), charted = chart.printed();
    const page = getComputedStyle(document.body);
    /** @type {import("../views/picture.js").View[]} */
    const views = charted ? [charted] : [];
    if (picture) views.unshift({ width: SIZE, height: SIZE, draw: (to) => paint(to, SIZE, picture, LIGHT) });
    return { title: title(), line: line(this.asked), views,
      verdict: { text: badge && decided && !decided.answer.error ? text(badge) : "",
        more: all("#verdict .damped").map(text).join(), colour: badge ? getComputedStyle(badge).color : "" },
      key: charted ? all("#charted .key li").map((item) => ({ text: text(item),
        colour: getComputedStyle(item.querySelector("span")).backgroundColor })) : [],
      numbers: Object.entries(decided?.question.values ?? {}).map((pair) => pair.join(" = ")),
      inks: { ink: page.color, paper: page.backgroundColor, quiet: getComputedStyle(at("source")).color,
        line: getComputedStyle(at("decision")).borderTopColor } };
  }

  /** The picture on paper, or why there is none; formulas that are wider than it become smaller. */
  paper() {
    const seen = this.seen(), { documentElement } = new DOMParser().parseFromString(svg(seen), "image/svg+xml");
    at("printed").replaceChildren(!this.waiting && seen.verdict.text ? documentElement
      : "The page had no answer yet when it was printed: its pictures are left out.");
    for (const formula of all("#because .display, #derived .display")) {
      const parts = [...formula.querySelectorAll(".base")].map((part) => part.getBoundingClientRect());
      const wide = Math.max(...parts.map(({ right }) => right)) - Math.min(...parts.map(({ left }) => left));
      const letters = wide / parseFloat(getComputedStyle(formula).fontSize);
      formula.style.setProperty("--fit", Math.min(1, ACROSS / letters));
    }
  }
}
