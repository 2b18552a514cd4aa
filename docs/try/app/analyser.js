// The worker and what is asked of it: one question at a time, within a time, the newest of each kind.
export const LIMIT = 10;                                // seconds
const SIMPLER = "Write it more simply, or use the library on your own machine, where nothing ends it.";
const LATE = { error: `This took longer than ${LIMIT} s and was ended. ${SIMPLER}` };
const LOST = { lost: true, error: "The library is not running, see the top of this page." };

/**
 * @typedef {import("./answers.js").Answer} Answer
 * @typedef {(answer: Answer | null) => void} Resolve
 * @typedef {import("./progress.js").News & { failed?: string }} News failed where the library could not be started
 */

export class Analyser {
  constructor() {
    /** @type {News[]} what is told before there is somebody who listens */
    this.untold = [];
    /** @type {(news: News) => void} */
    this.told = (news) => { this.untold.push(news); };
    /** @type {Map<string, { resolve: Resolve, question: string }>} */
    this.waiting = new Map();
    /** @type {{ id: number, resolve: Resolve, late: ReturnType<typeof setTimeout> } | null} */
    this.asked = null;
    this.count = 0;
    this.started = this.ready = this.lost = false;
  }

  /** @param {(news: News) => void} told */
  listen(told) {
    this.told = told;
    for (const news of this.untold.splice(0)) told(news);
  }

  start() {
    this.started = true;
    this.ready = this.lost = false;
    const worker = this.worker = new Worker("app/worker.js", { type: "module" });
    worker.onmessage = ({ data }) => { if (worker === this.worker) this.heard(data); };
    worker.onerror = (event) => {
      event.preventDefault();
      if (worker === this.worker) this.failed(event.message || "a file of its worker did not come");
    };
  }

  /**
   * The answer, with error where there is none; null where a newer question of the same kind took its place.
   * @param {string} want
   * @param {any} scene
   * @param {any[]} more
   * @returns {Promise<Answer | null>}
   */
  ask(want, scene, more = []) {
    if (this.lost) return Promise.resolve(LOST);
    this.waiting.get(want)?.resolve(null);
    return new Promise((resolve) => {
      this.waiting.set(want, { resolve, question: JSON.stringify({ want, scene, more }) });
      this.next();
    });
  }

  next() {
    const [first] = this.waiting;
    if (!this.ready || this.asked || !first) return;
    const [want, { resolve, question }] = first;
    this.waiting.delete(want);
    const late = setTimeout(() => this.again(LATE), LIMIT * 1000);
    this.asked = { id: ++this.count, resolve, late };
    this.worker?.postMessage({ id: this.count, question });
  }

  /** @param {News & { id?: number, answer?: string }} message */
  heard({ id, answer, failed, ...news }) {
    if (failed) return this.failed(failed);
    if (id === undefined) {
      this.ready = this.ready || Boolean(news.ready);
      this.told(news);
    } else if (id === this.asked?.id) {
      this.done(JSON.parse(answer ?? ""));
    }
    this.next();
  }

  /** @param {Answer} answer */
  done(answer) {
    const { resolve, late } = this.asked ?? {};
    clearTimeout(late);
    this.asked = null;
    resolve?.(answer);
  }

  /** What fails at a question is started again; what fails at its start would fail again. @param {string} message */
  failed(message) {
    if (this.ready) return this.again({ error: `The computation failed (${message}). ${SIMPLER}` });
    this.worker?.terminate();
    this.lost = true;
    this.told({ failed: message });
    for (const { resolve } of this.waiting.values()) resolve(LOST);
    this.waiting.clear();
  }

  /** @param {Answer} answer */
  again(answer) {
    this.worker?.terminate();
    this.start();
    this.done(answer);
  }
}
