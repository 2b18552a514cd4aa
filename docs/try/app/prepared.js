// The answers of the examples, computed when the page was built: build.py writes them, one file for each example.
import { key } from "./answers.js";
import { numbered } from "./scene.js";

/**
 * @typedef {Record<string, { question: any, answer: Record<string, any> }>} Prepared of each kind a question and its answer
 */

/**
 * Finds the answer to a question of an example, as the page asks it; undefined of any other question.
 * @param {() => Promise<{ scene: any }[]>} examples
 * @param {(n: number) => Promise<Prepared>} file what was prepared of an example
 */
export function library(examples, file) {
  /** @type {Map<number, Promise<Prepared>>} */
  const files = new Map();
  /** @param {string} kind @param {any} question */
  return async (kind, question) => {
    const n = numbered(question.scene ?? question, await examples());
    if (n < 0) return undefined;
    if (!files.has(n)) files.set(n, file(n).catch(() => ({})));
    const found = (await files.get(n))?.[kind];
    return found && key(found.question) === key(question) ? found.answer : undefined;
  };
}
