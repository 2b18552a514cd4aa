// The worker and what is asked of it: one question at a time, within a time, the newest of each kind.
export const LIMIT = 10;                                // seconds

export class Analyser {
  // told: {step}, {ready}, {ended} where a question took too long, {broken} where the worker failed
  constructor(told) {
    this.told = told;
    this.waiting = new Map();
    this.asked = null;
    this.count = 0;
    this.start();
  }

  start() {
    this.ready = false;
    this.worker = new Worker("worker.js", { type: "module" });
    this.worker.onmessage = ({ data }) => this.heard(data);
    this.worker.onerror = (event) => this.failed(event.message);
  }

  // The answer; null where a newer question of the same kind took its place, or there is none.
  ask(want, scene, more = []) {
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
    const late = setTimeout(() => this.again({ ended: true }), LIMIT * 1000);
    this.asked = { id: ++this.count, resolve, late };
    this.worker.postMessage({ id: this.count, question });
  }

  heard({ id, answer, ...news }) {
    if (id === undefined) {
      this.ready = this.ready || Boolean(news.ready);
      this.told(news);
    } else if (id === this.asked?.id) {
      this.done(JSON.parse(answer));
    }
    this.next();
  }

  done(answer) {
    const { resolve, late } = this.asked ?? {};
    clearTimeout(late);
    this.asked = null;
    resolve?.(answer);
  }

  // What fails at its start would fail again; what fails at a question is started again.
  failed(message) {
    if (this.ready) this.again({ broken: message });
    else this.told({ failed: message });
  }

  again(news) {
    this.worker.terminate();
    this.done(null);
    this.start();
    this.told(news);
  }
}
