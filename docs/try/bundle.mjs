// Bundles the scripts of the page: one file for the page, and one for each of its threads. Usage: bundle.mjs STAGE TARGET,
// where build.py has unpacked esbuild in the folder STAGE.
import { readdirSync } from "node:fs";

const [stage, target] = process.argv.slice(2);
const { build, stop } = await import(`${stage}/esbuild/package/lib/main.js`);
const { metafile } = await build({
  absWorkingDir: import.meta.dirname, outbase: ".", outdir: target, bundle: true, minify: true, format: "esm", metafile: true,
  entryPoints: ["app/main.js", "app/worker.js", "app/unpacker.js", "numerics/chart-worker.js"] });
await stop();
for (const folder of ["app", "views", "numerics"]) {
  for (const name of readdirSync(`${import.meta.dirname}/${folder}`)) {
    if (!(`${folder}/${name}` in metafile.inputs)) throw new Error(`nothing loads ${folder}/${name}`);
  }
}
