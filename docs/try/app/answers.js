// What is answered: of each kind of question the newest answer, and the question that it answers. An answer is shown as
// the answer only beside its own question.

/**
 * @typedef {Record<string, any>} Answer
 * @typedef {object} Answered
 * @property {string} asked the question, as a text
 * @property {any} question
 * @property {Answer} answer
 * @property {string} [prepared] where it was prepared, and the library has not confirmed it: the question as it was sent
 */

/** @param {any} question */
export const key = (question) => JSON.stringify(question);

export class Answers {
  /**
   * @param {Record<string, (question: any) => Promise<Answer | null>>} ask of each kind; null where another question
   *   took its place
   * @param {() => void} settled called when an answer has come
   * @param {Record<string, (found: Answer, question: any) => any>} named of some kinds: takes note of an answer, and
   *   returns its question by its full name
   * @param {(kind: string, question: any) => Promise<Answer | undefined>} prepared an answer that is there before
   * @param {(kind: string) => void} differed called when the library answers otherwise
   */
  constructor(ask, settled, named = {}, prepared = async () => undefined, differed = () => {}) {
    this.ask = ask;
    this.prepared = prepared;
    this.differed = differed;
    this.settled = settled;
    this.named = named;
    /** @type {Record<string, string | null | undefined>} */
    this.asked = {};
    /** @type {Record<string, Answered>} */
    this.answered = {};
    /** @type {Record<string, ReturnType<typeof setTimeout>>} */
    this.later = {};
  }

  /**
   * Whether what is shown of a kind is of another question than the page's.
   * @param {string} kind
   */
  waiting(kind) {
    return this.asked[kind] !== (this.answered[kind]?.asked ?? null);
  }

  /**
   * The answer to the page's question; undefined if it has not come, or if there is no question.
   * @param {string} kind
   * @returns {Answer | undefined}
   */
  of(kind) {
    return this.waiting(kind) ? undefined : this.answered[kind]?.answer;
  }

  /**
   * The page's question of a kind: null where it has none, undefined while it is not known yet. It is asked after a
   * pause of so many milliseconds, in which another one takes its place.
   * @param {string} kind
   * @param {any} question
   */
  follow(kind, question, pause = 0) {
    const asked = question && key(question);
    if (asked === this.asked[kind]) return;
    this.asked[kind] = asked;
    clearTimeout(this.later[kind]);
    if (asked === null) {
      delete this.answered[kind];
    } else if (asked && this.waiting(kind)) {
      if (pause) this.later[kind] = setTimeout(() => this.send(kind, asked, question), pause);
      else this.send(kind, asked, question);
    }
  }

  /**
   * What was prepared is shown until the library has answered, which confirms it or takes its place.
   * @param {string} kind
   * @param {string} asked
   * @param {any} question
   */
  async send(kind, asked, question) {
    this.prepared(kind, question).then((answer) => {
      if (answer) this.take(kind, asked, question, answer, asked);
    });
    const answer = await this.ask[kind](question), early = this.answered[kind];
    if (!answer) return;
    if (early?.prepared !== asked) this.take(kind, asked, question, answer);
    else if (key(answer) === key(early.answer)) this.confirm(early);
    else if (!answer.lost) this.replace(kind, early, answer);
  }

  /**
   * @param {string} kind
   * @param {string} asked
   * @param {any} question
   * @param {Answer} answer
   * @param {string} [prepared]
   */
  take(kind, asked, question, answer, prepared) {
    if (asked !== this.asked[kind] || !this.waiting(kind)) return;
    const full = this.named[kind]?.(answer, question) ?? question;
    this.asked[kind] = key(full);
    this.answered[kind] = { asked: key(full), question: full, answer, prepared };
    this.settled();
  }

  /** @param {Answered} early */
  confirm(early) {
    delete early.prepared;
    this.settled();
  }

  /**
   * @param {string} kind
   * @param {Answered} early
   * @param {Answer} answer
   */
  replace(kind, early, answer) {
    this.answered[kind] = { ...early, answer, prepared: undefined };
    this.differed(kind);
    this.settled();
  }

  /**
   * The same question will be asked again.
   * @param {string} kind
   */
  forget(kind) {
    delete this.asked[kind];
    if (this.answered[kind]) this.answered[kind].asked = "";
  }
}
