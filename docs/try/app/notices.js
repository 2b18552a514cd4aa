// What fails of the page itself, in a sentence and with a way on.
import { element } from "../views/blocks.js";

/**
 * By what failed: a sentence, what a button says and does.
 * @type {Map<string, [text: string, way: string, go: () => void]>}
 */
const said = new Map();

/**
 * Says what failed, until it is said to be over by an empty text.
 * @param {string} what
 * @param {string} text
 * @param {string} way
 * @param {() => void} go
 */
export function notice(what, text, way, go) {
  if (text) said.set(what, [text, way, go]);
  else said.delete(what);
  const place = /** @type {HTMLElement} */ (document.getElementById("notice"));
  place.hidden = !said.size;
  place.replaceChildren(...[...said.values()].map(([text, way, onclick]) => element("p", {}, `${text} `,
    element("button", { type: "button", onclick }, way))));
}

/** @type {[way: string, go: () => void]} */
export const reload = ["Load the page again", () => location.reload()];

/**
 * A file of the page did not come, which another attempt may bring.
 * @type {(what: string, without: string) => void}
 */
export const lost = (what, without) => notice(what, `${what} could not be loaded: ${without}`, ...reload);
