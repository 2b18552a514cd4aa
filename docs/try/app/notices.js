// What fails of the page itself, in a sentence and with a way on.
import { element } from "../views/blocks.js";

const said = new Map();                                 // by what failed: a sentence, what a button says and does

export function notice(what, text, way, go) {
  if (text) said.set(what, [text, way, go]);
  else said.delete(what);
  const place = document.getElementById("notice");
  place.hidden = !said.size;
  place.replaceChildren(...[...said.values()].map(([text, way, onclick]) => element("p", {}, `${text} `,
    element("button", { type: "button", onclick }, way))));
}

export const reload = ["Load the page again", () => location.reload()];

// A file of the page did not come, which another attempt may bring.
export const lost = (what, without) => notice(what, `${what} could not be loaded: ${without}`, ...reload);
