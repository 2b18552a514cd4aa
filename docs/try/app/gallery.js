// The examples, each with a picture, to pick from.
import { element } from "../views/blocks.js";

/**
 * A button for each example; the pictures are fetched when the list is opened.
 * @param {HTMLDetailsElement} place
 * @param {{ title: string, picture?: string }[]} examples
 * @param {(n: number) => void} picked
 */
export function gallery(place, examples, picked) {
  const list = element("ul");
  list.append(...examples.map(({ title, picture }, n) => {
    const shown = picture ? [element("img", { src: picture, alt: "", width: 64, height: 64, loading: "lazy" })] : [];
    const onclick = () => {
      place.open = false;
      picked(n);
    };
    return element("li", {}, element("button", { type: "button", onclick }, ...shown, ` ${title}`));
  }));
  place.append(list);
}
