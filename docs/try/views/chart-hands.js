// What fingers, a mouse and keys do to a picture: set its point, drag it, zoom, move what is seen.

const REACH = 22, STILL = 10;                           // pixels: of a finger around the point; of a tap
const WHEEL = 0.002, PINCH = 0.01;                      // of a pixel of a wheel, of a trackpad's fingers
const LINE = 16, PAUSE = 400;                           // pixels; milliseconds between two turns of a wheel
const ZOOM = 1.25;                                      // of a key
/** @type {Record<string, Place>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
/** @type {Record<string, number>} */
const ZOOMS = { "+": 1 / ZOOM, "=": 1 / ZOOM, "-": ZOOM, "_": ZOOM };

/** @typedef {[number, number]} Place  in pixels of the picture */
/** @typedef {{id: number, touch: boolean, shift: boolean, place: Place}} Pointer */
/**
 * @typedef {object} Deeds
 * @property {() => Place | null} point where the point is, null if it is not seen
 * @property {(place: Place) => boolean} within whether the point can be there
 * @property {(place: Place) => void} set
 * @property {(place: Place, step: Place) => void} step sets the point a step beside a place, upwards positive
 * @property {(from: Place, to: Place, factor: number) => void} stretch what is seen at one place comes to
 *   another, and all becomes so many times as far apart
 */

/** @param {Place} a @param {Place} b */
const apart = ([x, y], [u, v]) => Math.hypot(x - u, y - v);

/**
 * What pointers that go down, move and up mean. A finger beside the point is left to the page, which scrolls
 * by it, unless it goes up where it was.
 */
export class Hands {
  /** @param {Deeds} deeds */
  constructor(deeds) {
    this.deeds = deeds;
    /** @type {Map<number, Place>} */
    this.down = new Map();
    /** @type {"" | "tap" | "drag" | "pan" | "pinch"} */
    this.mode = "";
    /** @type {Place} */
    this.start = [0, 0];
    /** @type {Place} from a finger to the point that it drags */
    this.offset = [0, 0];
  }

  /** Whether a finger at a place holds the point. @param {Place} place */
  holds(place) {
    const point = this.deeds.point();
    return point !== null && apart(point, place) <= REACH;
  }

  /** @param {Pointer} pointer */
  pressed({ id, touch, shift, place }) {
    if (!touch) this.down.clear();                      // a mouse has one pointer, whatever was lost before
    this.down.set(id, place);
    this.start = place;
    if (this.down.size > 1) this.mode = this.down.size === 2 ? "pinch" : "";
    else if (shift && !touch) this.mode = "pan";
    else if (!this.deeds.within(place) && !this.holds(place)) this.mode = "";
    else if (!touch) {
      this.mode = "drag";
      this.offset = [0, 0];
      this.deeds.set(place);
    } else if (this.holds(place)) {
      const [x, y] = this.deeds.point() ?? place;
      this.mode = "drag";
      this.offset = [x - place[0], y - place[1]];
    } else this.mode = "tap";
  }

  /** @param {Pointer} pointer */
  moved({ id, place }) {
    const before = this.down.get(id);
    if (!before) return;
    const others = [...this.down].filter(([other]) => other !== id).map(([, other]) => other);
    this.down.set(id, place);
    if (this.mode === "tap" && apart(this.start, place) > STILL) this.mode = "";
    if (this.mode === "drag") this.deeds.set([place[0] + this.offset[0], place[1] + this.offset[1]]);
    if (this.mode === "pan") this.deeds.stretch(before, place, 1);
    if (this.mode === "pinch") this.pinched(others[0], before, place);
  }

  /** One of two fingers moves. @param {Place} still @param {Place} before @param {Place} now */
  pinched(still, before, now) {
    /** @param {Place} a @returns {Place} */
    const middle = (a) => [(a[0] + still[0]) / 2, (a[1] + still[1]) / 2];
    const factor = Math.max(apart(still, before), 1) / Math.max(apart(still, now), 1);
    this.deeds.stretch(middle(before), middle(now), factor);
  }

  /** @param {Pointer} pointer */
  lifted({ id, place }) {
    if (this.mode === "tap" && this.down.has(id)) this.deeds.set(place);
    this.lost(id);
  }

  /** The page scrolls by this finger, or it is lifted. @param {number} id */
  lost(id) {
    if (this.down.delete(id)) this.mode = "";
  }
}

/** @param {HTMLElement} canvas @param {Deeds} deeds */
export function handled(canvas, deeds) {
  const hands = new Hands(deeds);
  /** @param {{clientX: number, clientY: number}} event @returns {Place} */
  const at = ({ clientX, clientY }) => {
    const { left, top } = canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  /** @param {PointerEvent} event @returns {Pointer} */
  const pointer = (event) => ({ id: event.pointerId, touch: event.pointerType === "touch",
    shift: event.shiftKey, place: at(event) });

  canvas.onpointerdown = (event) => {
    if (event.button === 0) hands.pressed(pointer(event));
  };
  // A mouse that has been pressed on the picture moves its point from outside too.
  addEventListener("pointermove", (event) => hands.moved(pointer(event)));
  addEventListener("pointerup", (event) => hands.lifted(pointer(event)));
  addEventListener("pointercancel", (event) => hands.lost(event.pointerId));
  // The style leaves one finger to the page, which scrolls by it, unless it holds the point or there are two.
  canvas.addEventListener("touchstart", (event) => {
    const [finger] = event.targetTouches;
    if (event.touches.length > 1 || hands.holds(at(finger))) event.preventDefault();
  }, { passive: false });
  canvas.onkeydown = (event) => {
    const { key } = event, middle = canvas.clientWidth / 2;
    if (!(key in ARROWS || key in ZOOMS) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const place = deeds.point() ?? [middle, middle];
    if (key in ARROWS) deeds.step(place, ARROWS[key]);
    else deeds.stretch(place, place, ZOOMS[key]);
  };
  wheeled(canvas, (event) => {
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE : 1;
    deeds.stretch(at(event), at(event), Math.exp(event.deltaY * lines * (event.ctrlKey ? PINCH : WHEEL)));
  });
}

/**
 * A wheel that has begun to turn over the picture turns for it; one that scrolls the page goes on to do so.
 * @param {HTMLElement} canvas
 * @param {(event: WheelEvent) => void} turned
 */
function wheeled(canvas, turned) {
  let last = -PAUSE, ours = false;
  addEventListener("wheel", ({ target, timeStamp }) => {
    if (timeStamp - last > PAUSE) ours = target === canvas;
    last = timeStamp;
  }, { capture: true, passive: true });
  canvas.addEventListener("wheel", (event) => {
    if (!ours && !event.ctrlKey) return;                // a trackpad's pinch comes as a wheel with ctrl
    event.preventDefault();
    turned(event);
  }, { passive: false });
}
