// How the page is shown: whole, as a part of another page, or in a lecture, in large letters.
import { say } from "../views/blocks.js";
import { address, title } from "./sharing.js";
import { line } from "./scene.js";

const MODES = ["embed", "lecture"];
/** @type {Record<string, number>} */
const STEPS = { n: 1, PageDown: 1, p: -1, PageUp: -1 };
/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);

export class Modes {
  /**
   * @param {import("./scene.js").Asked} asked
   * @param {(by: number) => void} step to the next example, or to the one before
   * @param {() => void} update
   */
  constructor(asked, step, update) {
    this.asked = asked;
    this.step = step;
    this.update = update;
    at("lecture").onclick = () => this.lecture();
    at("leave").onclick = () => this.leave();
    document.addEventListener("keydown", (event) => this.key(event));
    document.addEventListener("fullscreenchange", () => { if (!document.fullscreenElement) this.leave(); });
  }

  /** What stands on top of a scene that is shown alone. */
  follow() {
    const { asked } = this, { dataset } = document.documentElement;
    if (MODES.includes(asked.show)) dataset.show = asked.show;
    else delete dataset.show;
    say(at("titled"), title() || line(asked));
    if (asked.show === "embed") at("titled").href = address(asked, "");
    else at("titled").removeAttribute("href");
  }

  /** Over the whole screen, where the browser lets a page have it. */
  lecture() {
    this.asked.show = "lecture";
    at("asked").open = false;
    this.update();
    document.documentElement.requestFullscreen?.().catch(() => {});
    this.focus("#values [type=range]");
    scrollTo(0, 0);
  }

  leave() {
    if (this.asked.show !== "lecture") return;
    this.asked.show = "";
    this.update();
    if (document.fullscreenElement) document.exitFullscreen();
    this.focus("#lecture");
  }

  /** @param {string} place */
  focus(place) {
    /** @type {any} */ (document.querySelector(place))?.focus();
  }

  /** Arrows are the focused slider's; a text that is typed has its letters. @param {KeyboardEvent} event */
  key(event) {
    const { key, altKey, ctrlKey, metaKey } = event, by = STEPS[key];
    const typed = /** @type {Element} */ (event.target);
    if (this.asked.show !== "lecture" || altKey || ctrlKey || metaKey) return;
    if (key === "Escape") this.leave();
    if (!by || key.length === 1 && typed.matches("input:not([type=range])")) return;
    event.preventDefault();
    this.step(by);
  }
}
