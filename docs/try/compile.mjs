// Runs compiled.py in the Pyodide of the folder that build.py has filled.
import { readFileSync } from "node:fs";

const [stage, script] = process.argv.slice(2);
const { loadPyodide } = await import(`${stage}/pyodide/package/pyodide.mjs`);
const python = await loadPyodide();
python.mountNodeFS("/stage", stage);
python.runPython(readFileSync(script, "utf8"));
