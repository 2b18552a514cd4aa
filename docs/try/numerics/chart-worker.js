// Pictures of charts in a thread of their own: a program once, then numbers as often as they change; of those
// that have come while a picture was drawn the newest.
import { Regions } from "./regions.js";

/** @type {Regions} */
let regions;
let size = 0;
/** @type {{numbers: Record<string, number>, ends: [number, number][], chart: string, asked: string}} */
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
  const { numbers, ends, chart, asked } = newest;
  const rows = regions.drawn(numbers, ends), codes = new Uint8Array(size * size);
  for (let y = 0; y < size; y++) {                      // the highest row first
    codes.set(rows.subarray(y * size, (y + 1) * size), (size - 1 - y) * size);
  }
  postMessage({ codes, ends, chart, asked }, [codes.buffer]);
}
