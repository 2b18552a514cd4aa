// Pictures of charts in a thread of their own: a program once, then numbers as often as they change.
import { Regions } from "./regions.js";

let regions, size;

onmessage = ({ data: { chart, axes, width, numbers, ends, colours } }) => {
  if (chart) {
    size = width;
    regions = new Regions(chart, axes, size);
  }
  if (!numbers) return;
  const codes = regions.drawn(numbers, ends), pixels = new Uint8ClampedArray(4 * size * size);
  const inks = new Uint32Array(new Uint8Array(colours.flat()).buffer), out = new Uint32Array(pixels.buffer);
  for (let y = 0; y < size; y++) {                      // the highest row first
    for (let x = 0; x < size; x++) out[(size - 1 - y) * size + x] = inks[codes[y * size + x]];
  }
  postMessage(pixels, [pixels.buffer]);
};
