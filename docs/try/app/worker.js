// The library in a thread of its own: Python, its packages from the archives that files.json lists, then answers.

const FOLDER = "/packages/";                            // finder.py names it too
// What an archive of the runtime brings, in the words of the page.
const PARTS = { "runtime/python.xz": "Python", "runtime/flint.xz": "FLINT", "runtime/packages.xz": "SymPy" };

/** @param {string} step */
const say = (step) => postMessage({ step });
/** @param {any} error */
const fail = (error) => postMessage({ failed: error.message ?? String(error) });

// Pyodide waits without end for a file of its own that does not come: whatever fails here ends the start.
self.onunhandledrejection = ({ reason }) => fail(reason);

/** @typedef {{ name: string, got: number, of: number }} Part how many bytes of a part have come */
/** @typedef {import("./unpacker.js").Modules} Modules */
/** @typedef {{ files: import("./unpacker.js").Files, compiled: Promise<Modules> }} Archive */

/** @type {{ unpacker: Worker, kept: Promise<void> }[]} */
const unpackers = [];

/**
 * Each archive of the runtime, by its name; what has come of them is told on the way.
 * @param {Record<string, { bytes: number, integrity: string }>} files
 */
function archives(files) {
  /** @type {Part[]} */
  const parts = Object.entries(PARTS).map(([file, name]) => ({ name, got: 0, of: files[file].bytes }));
  const tell = () => postMessage({ parts });
  tell();
  /** @param {string} name @param {number} n @returns {Promise<Archive>} */
  const archive = (name, n) => new Promise((resolve, reject) => {
    const unpacker = new Worker(new URL("unpacker.js", import.meta.url), { type: "module" });
    unpacker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message || "unpacker.js: it did not come"));
    };
    /** @type {(nothing: void) => void} */
    let over;
    /** @type {(found: Modules) => void} */
    let taken;
    /** @type {Promise<Modules>} */
    const modules = new Promise((take) => { taken = take; });
    unpackers.push({ unpacker, kept: new Promise((end) => { over = end; }) });
    unpacker.onmessage = ({ data: { got, files: found, compiled, kept, failed } }) => {
      if (kept) return over();
      if (compiled) return taken(compiled);
      if (failed) return fail(new Error(failed));
      parts[n].got = found ? parts[n].of : got;
      tell();
      if (found) resolve({ files: found, compiled: modules });
    };
    unpacker.postMessage({ name, integrity: files[name].integrity });
  });
  // Two at a time: what Python needs to start is not to wait for what is needed later.
  const [first, second, third] = Object.keys(PARTS), runtime = archive(first, 0);
  return [runtime, archive(second, 1), runtime.then(() => archive(third, 2))];
}

/** Python, from the files of its archive, which it asks for by their names. @param {Archive} archive */
async function interpreter({ files: runtime, compiled }) {
  const fetched = self.fetch.bind(self);
  self.fetch = async (address, options) => {
    const asked = /** @type {any} */ (address).url ?? String(address);
    const data = runtime.get(asked.slice(asked.lastIndexOf("/") + 1));
    if (!data) return fetched(address, options);
    return new Response(asked.endsWith(".wasm") ? null : data);
  };
  // What the loader asks for as a stream is compiled already.
  WebAssembly.instantiateStreaming = async (_, imports) => {
    const module = /** @type {WebAssembly.Module} */ ((await compiled).get("pyodide.asm.wasm"));
    try {
      return { module, instance: await WebAssembly.instantiate(module, imports) };
    } catch (error) {
      fail(error);
      throw error;
    }
  };
  /** @param {string} name */
  const bytes = (name) => /** @type {Uint8Array<ArrayBuffer>} */ (runtime.get(name));
  const script = URL.createObjectURL(new Blob([bytes("pyodide.asm.mjs")], { type: "text/javascript" }));
  const [{ loadPyodide }, { default: createPyodideModule }] = await Promise.all([
    import(new URL("../runtime/pyodide.mjs", import.meta.url).href), import(script)]);
  return loadPyodide({ createPyodideModule, stdLibURL: new URL("../runtime/python.zip", import.meta.url).href,
    lockFileContents: new TextDecoder().decode(runtime.get("pyodide-lock.json")) });
}

/** @param {BufferSource} data */
async function hash(data) {
  const found = await self.crypto.subtle?.digest("SHA-256", data);
  return found && `sha256-${btoa(String.fromCharCode(...new Uint8Array(found)))}`;
}

async function started() {
  const response = await fetch("../files.json", { cache: "no-cache" }).catch(() => undefined);
  if (!response?.ok) throw new Error(`files.json: ${response?.status ?? "it did not come"}`);
  const list = await response.arrayBuffer();
  const [runtime, ...packages] = archives(JSON.parse(new TextDecoder().decode(list)));
  const version = await hash(list);
  const python = await interpreter(await runtime);
  say("packages");
  const libraries = new Map();
  for (const { files, compiled } of await Promise.all(packages)) {
    for (const [path, data] of files) {
      const file = FOLDER + path;
      python.FS.mkdirTree(file.slice(0, file.lastIndexOf("/")));
      python.FS.writeFile(file, data, { canOwn: true });
    }
    for (const [path, found] of await compiled) libraries.set(FOLDER + path, found);
  }
  Object.assign(self, { compiled: libraries });         // linked.py makes the loader look there
  python.runPython(python.FS.readFile(`${FOLDER}finder.py`, { encoding: "utf8" }));
  say("library");
  return { answer: python.pyimport("session").answer, version };
}

try {
  const { answer, version } = await started();
  self.onunhandledrejection = null;
  onmessage = ({ data: { id, question } }) => postMessage({ id, answer: answer(question) });
  postMessage({ ready: true });
  for (const { unpacker } of unpackers) unpacker.postMessage({});
  await Promise.all(unpackers.map(({ kept }) => kept));
  if (version) postMessage({ version });
} catch (error) {
  fail(error);
}
