// Runs compiled.py in the Pyodide of the folder that build.py has filled, prepares the answers of
// the examples, and draws their pictures.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { pictured } from "./pictures.mjs";
import { prepared } from "./prepare.mjs";

const [stage, script] = process.argv.slice(2);
const { loadPyodide } = await import(`${stage}/pyodide/package/pyodide.mjs`);
const python = await loadPyodide();
python.mountNodeFS("/stage", stage);
python.runPython(readFileSync(script, "utf8"));
const { answer } = python.pyimport("session");
const examples = JSON.parse(readFileSync(`${stage}/packages/examples.json`, "utf8"));
for (const folder of ["prepared", "pictures"]) mkdirSync(`${stage}/${folder}`);
for (const [n, example] of examples.entries()) {
  const found = await prepared(example, (question) => JSON.parse(answer(JSON.stringify(question))));
  writeFileSync(`${stage}/prepared/${n}.json`, JSON.stringify(found));
  const [ending, picture] = pictured(found);
  example.picture = `pictures/${n}.${ending}`;
  writeFileSync(`${stage}/${example.picture}`, picture);
}
writeFileSync(`${stage}/examples.json`, JSON.stringify(examples));
