// What Back leads to: of each scene one entry of the browser's history, with its newest numbers.

/** Browsers take an address some hundred times in half a minute, then refuse; a slider moves oftener. */
export const OFTEN = 400;                               // milliseconds between two addresses
/** Those parts of an address that are no part of its scene. */
const BESIDE = ["set", "axes", "ends", "show"];

/**
 * The scene of an address, to tell whether two are the same.
 * @param {string} address `#` and what follows
 * @returns {string}
 */
export function sceneOf(address) {
  const parts = new URLSearchParams(address.slice(1));
  for (const name of BESIDE) parts.delete(name);
  return String(parts);
}

/** The entries: a scene that the visitor sets makes one, all else belongs to the one that is there. */
export class Entries {
  /**
   * @param {(address: string) => void} push makes an entry
   * @param {(address: string) => void} replace gives the one that is there another address
   * @param {() => string} here the address that the browser has: it may have gone back just now
   * @param {() => number} now milliseconds
   */
  constructor(push, replace, here, now = () => performance.now()) {
    this.push = push;
    this.replace = replace;
    this.here = here;
    this.now = now;
    /** What the browser has, and what it will have. */
    this.written = this.address = this.scene = "";
    this.field = "";
    this.next = 0;
    this.fresh = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */
    this.later = undefined;
  }

  /**
   * The address has come from the browser: a link, Back, or what was typed above the page.
   * @param {string} address
   */
  arrived(address) {
    this.written = this.address = address;
    this.scene = sceneOf(address);
    this.field = "";
    this.fresh = false;
  }

  /**
   * The address of what is on the page now.
   * @param {string} address
   * @param {string} [by] what set another scene: the field in which it is typed, or "" for all else; none if
   * the library has filled in what the visitor left open
   */
  follow(address, by) {
    const scene = address === this.address ? this.scene : sceneOf(address), other = scene !== this.scene;
    if (other && by !== undefined && (by === "" || by !== this.field)) {
      if (!this.fresh && this.later !== undefined) this.before();
      this.fresh = true;
    }
    if (by !== undefined) this.field = by;
    this.address = address;
    this.scene = scene;
    this.later ??= setTimeout(() => this.write(), by ? OFTEN : Math.max(0, this.next - this.now()));
  }

  /** The scene that is left gets its newest numbers; the one that comes then waits longer. */
  before() {
    this.write();
    this.next += OFTEN;
  }

  write() {
    clearTimeout(this.later);
    const { address, written } = this, push = this.fresh && sceneOf(address) !== sceneOf(written);
    this.later = undefined;
    this.fresh = false;
    if (address === written || written !== this.here()) return;
    this.next = this.now() + OFTEN;
    this.written = address;
    if (push) this.push(address);
    else this.replace(address);
  }
}
