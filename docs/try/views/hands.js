// How a view in space is turned: a drag, the arrow keys; a double click or the key 0 turns it back.

/** @type {Record<string, [number, number]>} */
const KEYS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
const SPEED = 1 / 150;                                  // rad of a pixel

/**
 * A finger that moves up or down scrolls the page; the browser does that by the style touch-action: pan-y.
 * @param {HTMLElement} place
 * @param {(across: number, up: number) => void} turn in rad
 * @param {() => void} back
 */
export function turning(place, turn, back) {
  /** @type {number[] | null} */
  let from = null;
  place.onpointerdown = ({ pointerId, clientX, clientY }) => {
    place.setPointerCapture(pointerId);
    from = [clientX, clientY];
  };
  place.onpointermove = ({ pointerType, clientX, clientY }) => {
    if (!from) return;
    turn((clientX - from[0]) * SPEED, pointerType === "touch" ? 0 : (clientY - from[1]) * SPEED);
    from = [clientX, clientY];
  };
  place.onpointerup = place.onpointercancel = () => { from = null; };
  place.ondblclick = back;
  place.onkeydown = (event) => {
    if (event.key !== "0" && !KEYS[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    if (event.key === "0") back();
    else turn(...KEYS[event.key]);
  };
}
