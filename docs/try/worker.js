// The library in a thread of its own: Python, its packages from the files that files.json lists, then answers.
import { loadPyodide } from "./runtime/pyodide.mjs";

const say = (step) => postMessage({ step });

async function listed(files, name) {
  const { integrity } = files[name];
  const response = await fetch(`${name}?${integrity.slice(7, 15)}`, { integrity });
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  return response.arrayBuffer();
}

async function inflated(data) {
  return new Response(new Blob([await data]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
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
  const files = await (await fetch("files.json", { cache: "no-cache" })).json();
  const packages = listed(files, "runtime/packages.zip");
  const libraries = inflated(listed(files, "runtime/libraries.bin"));
  say("interpreter");
  const python = await loadPyodide({ stdLibURL: new URL("runtime/python.zip", self.location).href });
  say("packages");
  placed(python.FS, "/libraries", await libraries);
  python.FS.writeFile("/packages.zip", new Uint8Array(await packages));
  python.runPython('import sys; sys.path[:0] = ["/libraries", "/packages.zip"]');
  say("library");
  return python.pyimport("session").answer;
}

try {
  const answer = await started();
  onmessage = ({ data: { id, question } }) => postMessage({ id, answer: answer(question) });
  postMessage({ ready: true });
} catch (error) {
  postMessage({ failed: error.message });
}
