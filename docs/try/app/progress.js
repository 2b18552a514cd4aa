// How far the start of the library is, in the words of the page.

/**
 * @typedef {{ name: string, got: number, of: number }} Part how many bytes of a part have come
 * @typedef {{ parts?: Part[], step?: string, ready?: boolean, version?: string }} News what the library's thread tells of its start
 */

/** @type {Record<string, string>} */
const STEPS = { packages: "Python runs, SymPy and FLINT follow", library: "all is here, the library is loading" };

/** @param {number} bytes */
const millions = (bytes) => (bytes / 1e6).toFixed(1);

/**
 * The share that has come, and a sentence; without parts only the sentence.
 * @param {News} news
 * @returns {{ share?: number, text: string }}
 */
export function progress({ parts, step, ready }) {
  if (!parts) return { text: ready ? "ready" : STEPS[step ?? ""] ?? "Python is loading" };
  const got = parts.reduce((sum, part) => sum + part.got, 0), of = parts.reduce((sum, part) => sum + part.of, 0);
  const missing = parts.filter((part) => part.got < part.of).map(({ name }) => name);
  const names = missing.length > 1 ? `${missing.slice(0, -1).join(", ")} and ${missing.at(-1)}` : missing[0];
  return { share: got / of, text: missing.length ? `${millions(got)} of ${millions(of)} MB: ${names}` : "all has come, Python starts" };
}
