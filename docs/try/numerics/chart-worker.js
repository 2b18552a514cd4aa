// Pictures of charts in a thread of their own: a program once, then numbers as often as they change; of those
// that have come while a picture was drawn the newest.
import { Regions } from "./regions.js";

/** @type {Regions} */
let regions;
let size = 0;
/** @type {any} */
let newest;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let due;

onmessage = ({ data }) => {
  if (data.width) {
    clearTimeout(due);                                  // numbers of the chart before
    due = undefined;
    size = data.width;
    regions = new Regions(data.chart, data.axes, size);
  } else {
    newest = data;
    due ??= setTimeout(draw);
  }
};

function draw() {
  due = undefined;
  const { numbers, ends, colours, chart, asked } = newest;
  const codes = regions.drawn(numbers, ends), pixels = new Uint8ClampedArray(4 * size * size);
  const inks = new Uint32Array(new Uint8Array(colours.flat()).buffer), out = new Uint32Array(pixels.buffer);
  for (let y = 0; y < size; y++) {                      // the highest row first
    for (let x = 0; x < size; x++) out[(size - 1 - y) * size + x] = inks[codes[y * size + x]];
  }
  postMessage({ pixels, ends, chart, asked }, [pixels.buffer]);
}
