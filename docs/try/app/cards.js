// The cards of the page, each drawn from an answer of the library.
import { shown, verdict } from "../views/blocks.js";
import { sliders } from "../views/sliders.js";

/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);

/**
 * By the kind of a question what draws its answer; it is called without one if the page has no such question.
 * @param {import("./scene.js").Asked} asked
 * @param {import("./form.js").Form} form
 * @param {() => void} changed called when a number is typed
 * @returns {Record<string, (found: any, question: any) => void>}
 */
export const cards = (asked, form, changed) => ({
  analysed(found) {
    form.offer(found);
    at("main").classList.toggle("listed", asked.equilibrium.startsWith("every"));
    at("error").textContent = found.error ?? "";
    at("derived").inert = Boolean(found.error);
    at("place").hidden = !found.point;
    at("opened").hidden = !found.open;
    at("derivation").hidden = Boolean(found.error);
    shown(at("point"), { blocks: found.point });
    shown(at("conditions"), { blocks: found.conditions });
    sliders(at("values"), found.names ?? [], asked, changed);
  },
  decided(found) {
    const { error = "", ...answer } = found ?? {};
    at("wrong").textContent = error;
    for (const text of at("values").querySelectorAll("input[id]")) {
      text.ariaInvalid = String(error.includes(`'${text.value}'`) || error.startsWith(`${text.id.slice(6)} = `));
    }
    verdict(at("verdict"), at("reasons"), answer);
  },
  survived(found) {
    shown(at("survived"), found);
  },
  opened(found) {
    shown(at("between"), found);
  },
  derived(found) {
    shown(at("blocks"), found);
  },
});
