// The form: its fields say what is asked, and what is typed in them is asked.
import { element } from "../views/blocks.js";
import { EMPTY, MADE } from "./made.js";
import { line, spun, TEXTS } from "./scene.js";

const PAUSE = 300;                                      // milliseconds after a key
const OWN = -1;                                         // the number of a scene that is no example
/** @param {string} id @returns {any} */
const at = (id) => document.getElementById(id);

export class Form {
  /**
   * @param {import("./scene.js").Asked} asked
   * @param {(pause?: number, field?: string) => void} changed called when something is typed, in a field, or picked
   * @param {(n: number) => void} picked called with the number of an example
   */
  constructor(asked, changed, picked) {
    this.asked = asked;
    this.changed = changed;
    for (const name of TEXTS) at(name).oninput = () => this.typed(name, () => { asked.texts[name] = at(name).value; });
    at("made").oninput = () => this.typed("made", () => { asked.made[at("made").name] = at("made").value; });
    at("ask").onsubmit = () => false;
    at("spin").onchange = () => {
      asked.spin = at("spin").value;
      spun(asked);
      changed();
    };
    at("example").onchange = () => picked(Number(at("example").value));
  }

  /** What is typed is another scene than the example. @param {string} field @param {() => void} take */
  typed(field, take) {
    take();
    this.named(OWN, "");
    this.changed(PAUSE, field);
  }

  /** The examples to pick from, and what stands there else. @param {{ title: string }[]} examples */
  list(examples) {
    at("example").append(...examples.map(({ title }, n) => element("option", { value: n }, title)),
      element("option", { value: OWN, hidden: true, disabled: true }, "Your scene"));
  }

  /** Which example it is, OWN for none, and where it is from. @param {number} example @param {string} source */
  named(example, source) {
    at("example").value = example;
    at("source").textContent = source;
    at("line").textContent = line(this.asked);
  }

  /** What is asked, in the fields. @param {number} example @param {string} source */
  fill(example, source) {
    for (const name of TEXTS) at(name).value = this.asked.texts[name];
    at("spin").value = this.asked.spin;
    this.named(example, source);
  }

  /**
   * The equilibria of a scene, and a row for what the one that is chosen is made with; of a scene that is refused the
   * list of the scene before.
   * @param {any} found
   */
  offer(found) {
    const { asked } = this;
    if (found.equilibria) {
      this.choices(found);
      this.making(found.made_with);
    } else {
      for (const input of at("equilibria").querySelectorAll("input")) input.checked = input.value === asked.equilibrium;
      if (asked.equilibrium === "point") this.making("point");            // for what is to be typed
      else if (at("made").name === "point") at("made-row").hidden = true;
    }
    at("line").textContent = line(asked);
  }

  /** @param {any} found */
  choices({ equilibria, chosen, place }) {
    const held = at("equilibria").contains(document.activeElement);
    at("equilibria").replaceChildren(...equilibria.map((/** @type {any} */ { name, title, why }) => {
      const input = element("input", { type: "radio", name: "equilibrium", value: name, checked: name === chosen });
      input.onchange = () => {
        if (name === "point" && !this.asked.made.point) this.asked.made.point = place ?? "";
        this.asked.equilibrium = name;
        this.changed();
      };
      return element("label", { title: why, className: why ? "none" : "" }, input, ` ${name} `,
        element("small", {}, why ? "not here" : title === `rotation about ${name}` ? "" : title));
    }));
    if (held) at("equilibria").querySelector(":checked").focus();
  }

  /** @param {string} name */
  making(name) {
    at("spin-row").hidden = name !== "spin";
    at("made-row").hidden = !(name in MADE);
    if (!(name in MADE)) return;
    at("made-label").textContent = MADE[name];
    at("made").name = name;
    at("made").value = this.asked.made[name] ?? EMPTY[name] ?? "";
  }
}
