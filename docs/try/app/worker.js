// The library in a thread of its own: Python, its packages from the files that files.json lists, then answers.
import { loadPyodide } from "../runtime/pyodide.mjs";
import "../runtime/xz.js";

const say = (step) => postMessage({ step });
const fail = (error) => postMessage({ failed: error.message });

// Pyodide waits without end for a file of its own that does not come: whatever fails here ends the start.
self.onunhandledrejection = ({ reason }) => fail(reason);
const fetched = self.fetch.bind(self);
self.fetch = async (address, options) => {
  const name = new URL(address.url ?? address, self.location).pathname.split("/").at(-1);
  const response = await fetched(address, options).catch((error) => error);
  if (response.ok) return response;
  const error = new Error(`${name}: ${response.status ?? "it did not come, or not whole"}`);
  fail(error);
  throw error;
};
const compile = WebAssembly.instantiateStreaming;
WebAssembly.instantiateStreaming = (...given) => compile(...given).catch((error) => {
  fail(error);
  throw error;
});

// A file that is listed, decompressed; where the browser lets a page keep something, it is kept so.
async function unpacked(files, name) {
  const { integrity } = files[name], address = `../${name}?${integrity.slice(7, 15)}`;
  const store = await self.caches?.open("gyrostat").catch(() => undefined);
  const kept = await store?.match(address);
  if (kept) return kept.arrayBuffer();
  const response = await fetch(address, { integrity });
  const { XzReadableStream } = self["xz-decompress"];
  const data = await new Response(new XzReadableStream(response.body)).arrayBuffer();
  keep(store, address, data.slice()).catch(() => {});   // a browser that is full starts without
  return data;
}

// One file, the newest.
async function keep(store, address, data) {
  for (const old of await store.keys()) await store.delete(old);
  await store.put(address, new Response(data));
}

// The files of a stream that build.py wrote: the length of a list, the list of paths and sizes, their bytes.
function placed(FS, folder, stream) {
  let at = 4 + new DataView(stream).getUint32(0, true);
  for (const [path, size] of JSON.parse(new TextDecoder().decode(new Uint8Array(stream, 4, at - 4)))) {
    const file = `${folder}/${path}`;
    FS.mkdirTree(file.slice(0, file.lastIndexOf("/")));
    FS.writeFile(file, new Uint8Array(stream, at, size), { canOwn: true });
    at += size;
  }
}

async function started() {
  const files = await (await fetch("../files.json", { cache: "no-cache" })).json();
  const packages = unpacked(files, "runtime/packages.xz");
  say("interpreter");
  const python = await loadPyodide({ stdLibURL: new URL("../runtime/python.zip", self.location).href });
  say("packages");
  placed(python.FS, "/packages", await packages);
  python.runPython('import sys; sys.path[:0] = ["/packages", "/packages/packages.zip"]');
  say("library");
  return python.pyimport("session").answer;
}

try {
  const answer = await started();
  self.onunhandledrejection = null;
  onmessage = ({ data: { id, question } }) => postMessage({ id, answer: answer(question) });
  postMessage({ ready: true });
} catch (error) {
  fail(error);
}
