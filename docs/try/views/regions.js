// The regions of a chart as a picture: a thread computes what each pixel is, its colour is given here.
import { element } from "./blocks.js";

/** @typedef {import("./scales.js").Ends} Ends */

export const SIZE = 400;                                // pixels, each way

export class Regions {
  /**
   * @param {() => void} settled called when a picture has come
   * @param {(why: string) => void} failed
   */
  constructor(settled, failed) {
    this.settled = settled;
    this.image = element("canvas", { width: SIZE, height: SIZE });
    this.data = new ImageData(SIZE, SIZE);
    /** @type {number[][]} */
    this.colours = [];
    /** @type {Uint8Array | null} */
    this.codes = null;
    /** @type {Ends[] | null} those of the picture that is shown */
    this.ends = null;
    /** @type {string | null | undefined} the chart */
    this.loaded = null;
    /** @type {string | null | undefined} the picture that is wanted */
    this.wanted = null;
    /** @type {string | null | undefined} the one that is shown */
    this.shown = null;
    this.worker = new Worker("numerics/chart-worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => this.come(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      failed(event.message || "a file of it did not come");
    };
  }

  /** Whether what is shown is of other numbers, or of another chart. */
  get waiting() {
    return this.wanted !== null && this.wanted !== this.shown;
  }

  /**
   * A program, or none.
   * @param {any} program
   * @param {string[]} axes
   * @param {string | undefined} key of the chart
   */
  load(program, axes, key) {
    this.shown = this.ends = null;
    this.loaded = key;
    if (program) this.worker.postMessage({ chart: program, axes, width: SIZE });
  }

  /**
   * What the picture is wanted of, null for none, undefined if that is not known yet. Pictures of numbers
   * before are shown on the way to it.
   * @param {{ends: Ends[], numbers: Record<string, number>} | null | undefined} question
   */
  want(question) {
    const asked = question && JSON.stringify([this.loaded, question]);
    if (asked === this.wanted) return;
    this.wanted = asked;
    if (asked) this.worker.postMessage({ ...question, chart: this.loaded, asked });
  }

  /** @param {{codes: Uint8Array, ends: Ends[], chart: string, asked: string}} data */
  come({ codes, ends, chart, asked }) {
    if (chart !== this.loaded) return;                  // of another chart
    this.codes = codes;
    this.ends = ends;
    this.shown = asked;
    this.paint(this.image);
    this.settled();
  }

  /**
   * The picture in the colours of this moment, into a canvas of its size.
   * @param {HTMLCanvasElement} canvas
   */
  paint(canvas) {
    if (!this.codes || !this.colours.length) return;
    const inks = new Uint32Array(new Uint8Array(this.colours.flat()).buffer);
    const { codes, data } = this, pixels = new Uint32Array(data.data.buffer);
    for (let n = 0; n < pixels.length; n++) pixels[n] = inks[codes[n]];
    canvas.getContext("2d")?.putImageData(data, 0, 0);
  }
}
