// One archive of the runtime in a thread of its own: fetched, compared with its hash, unpacked, and kept so where the
// browser lets a page keep something. The thread beside it starts Python meanwhile.

/** What is kept is unpacked already, and needs no decoder. */
const decoder = () => import(new URL("../runtime/xz.js", import.meta.url).href);

/** @param {string} name @param {string} integrity */
const key = (name, integrity) => new URL(`../${name}?${integrity}`, self.location.href).href;

/** @type {() => void} */
let told;
const started = new Promise((resolve) => { told = () => resolve(undefined); });

onmessage = ({ data: { name, integrity } }) => {
  if (!name) return told();                             // Python has started, there is time to keep something
  brought(name, integrity).catch((error) => postMessage({ failed: `${name}: ${error.message}` }));
};

/** @typedef {Map<string, Uint8Array<ArrayBuffer>>} Files */
/** @typedef {Map<string, WebAssembly.Module>} Modules */

/** @param {string} name @param {string} integrity */
async function brought(name, integrity) {
  const store = await self.caches?.open("gyrostat").catch(() => undefined);
  const kept = await store?.match(key(name, integrity));
  const ready = kept?.headers.has("unpacked") ? kept : undefined;
  const data = await (ready ?? await opened(kept ?? fetched(name, integrity), integrity, decoder())).arrayBuffer();
  const unpacked = ready ? null : new Response(data, { headers: { unpacked: "" } });
  const files = placed(data), compiling = compiled(files);              // of copies of their bytes
  postMessage({ files }, [data]);
  postMessage({ compiled: await compiling });
  await started;
  if (unpacked) await store?.put(key(name, integrity), unpacked).catch(() => {});     // a browser that is full starts without
  postMessage({ kept: true });
  self.close();
}

/**
 * The files of an archive that build.py wrote: the length of a list, the list of paths and sizes, their bytes.
 * @param {ArrayBuffer} data
 * @returns {Files}
 */
function placed(data) {
  let at = 4 + new DataView(data).getUint32(0, true);
  const found = new Map();
  for (const [path, size] of JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, at - 4)))) {
    found.set(path, new Uint8Array(data, at, size));
    at += size;
  }
  return found;
}

/**
 * What is compiled here, while the other thread goes on.
 * @param {Files} files
 * @returns {Promise<Modules>}
 */
async function compiled(files) {
  const binaries = [...files].filter(([path]) => /\.(so|wasm)$/.test(path));
  return new Map(await Promise.all(binaries.map(async ([path, data]) =>
    /** @type {const} */ ([path, await WebAssembly.compile(data)]))));
}

/** @param {string} name @param {string} integrity */
async function fetched(name, integrity) {
  // Where there is no digest, the browser compares, and tells nothing on the way.
  const response = await fetch(`../${name}`, self.crypto.subtle ? { cache: "no-cache" } : { cache: "no-cache", integrity })
    .catch(() => { throw new Error("it did not come"); });
  if (!response.ok) throw new Error(String(response.status));
  return response;
}

/**
 * The content of an archive, whose hash is compared when it is whole.
 * @param {Response | Promise<Response>} coming
 * @param {string} integrity
 * @param {Promise<any>} decoder
 */
async function opened(coming, integrity, decoder) {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const chunks = [];
  let got = 0;
  const counted = new TransformStream({
    transform(chunk, controller) {
      chunks.push(chunk);
      got += chunk.length;
      postMessage({ got });
      controller.enqueue(chunk.slice());                // the decoder may keep what it is given
    } });
  const [response] = await Promise.all([coming, decoder]);
  const { XzReadableStream } = /** @type {any} */ (self)["xz-decompress"];
  const data = await new Response(new XzReadableStream(response.body?.pipeThrough(counted))).arrayBuffer();
  const hash = await self.crypto.subtle?.digest("SHA-256", await new Blob(chunks).arrayBuffer());
  if (hash && `sha256-${btoa(String.fromCharCode(...new Uint8Array(hash)))}` !== integrity) {
    throw new Error("it did not come whole");
  }
  return new Response(data);
}
