// An answer, and the question that it answers: it is shown as the answer only beside that question.
export class Card {
  // ask(question): a promise of the answer, null where another one took its place; draw(answer, question): shows
  // it, with null nothing, and returns the question by its full name where it has one; settled(): called then
  constructor(ask, draw, settled) {
    Object.assign(this, { ask, draw, settled, answer: null, question: null, answered: null });
  }

  // Whether what is shown is of another question than the page's.
  get waiting() {
    return this.asked !== this.answered;
  }

  // The page's question now: null where it has none, undefined while it is not known yet. It is asked after a
  // pause of so many milliseconds, in which another one takes its place.
  follow(question, pause = 0) {
    const asked = question && JSON.stringify(question);
    if (asked === this.asked) return;
    this.asked = asked;
    clearTimeout(this.later);
    if (asked === null) {
      this.answer = this.question = this.answered = null;
      this.draw(null);
    } else if (asked && this.waiting) {
      if (pause) this.later = setTimeout(() => this.send(asked, question), pause);
      else this.send(asked, question);
    }
  }

  async send(asked, question) {
    const answer = await this.ask(question);
    if (!answer || asked !== this.asked || !this.waiting) return;
    Object.assign(this, { answer, question });
    const full = this.draw(answer, question);
    this.asked = this.answered = full ? JSON.stringify(full) : asked;   // what cannot be drawn stays marked
    this.settled();
  }

  // The same question will be asked again.
  forget() {
    this.asked = undefined;
    this.answered = null;
  }
}
