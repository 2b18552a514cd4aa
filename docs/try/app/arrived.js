// What of the page has come, and what it can do without.
import { unstyled } from "../views/blocks.js";
import { lost } from "./notices.js";

/** Says what has not come. */
export function checked() {
  if (!globalThis.katex) lost("katex/katex.min.js", "formulas stand here as they are written in LaTeX.");
  for (const link of document.querySelectorAll("link[rel=stylesheet]")) {
    if (styled(link)) continue;
    const name = link.getAttribute("href") ?? "", formulas = name.startsWith("katex");
    if (formulas) unstyled();
    lost(name, formulas ? "the browser sets the formulas." : name === "modes.css"
      ? "a scene alone, and paper, show the whole page." : "the page is plain, and has no chart.");
  }
}

/** Whether a style has come; the rules of one that has not are none, or cannot be asked for. @param {any} link */
function styled({ sheet }) {
  try {
    return sheet.cssRules.length > 0;
  } catch {
    return false;
  }
}
