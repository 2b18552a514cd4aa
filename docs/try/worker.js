// The library in a thread of its own: Python, its packages from the files that files.json lists, then answers.
import { loadPyodide } from "./runtime/pyodide.mjs";

const say = (step) => postMessage({ step });

async function listed(files, name) {
  const { integrity } = files[name];
  const response = await fetch(`${name}?${integrity.slice(7, 15)}`, { integrity });
  if (!response.ok) throw new Error(`${name}: ${response.status}`);
  return response.arrayBuffer();
}

async function started() {
  const files = await (await fetch("files.json", { cache: "no-cache" })).json();
  const packages = listed(files, "runtime/packages.zip");
  const libraries = listed(files, "runtime/libraries.zip");
  say("interpreter");
  const python = await loadPyodide({ stdLibURL: new URL("runtime/python.zip", self.location).href });
  say("packages");
  python.unpackArchive(await libraries, "zip", { extractDir: "/libraries" });
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
