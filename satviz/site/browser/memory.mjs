// Node runs this when a site is built: it starts Python with satviz and its first scene, and keeps the memory of that.
import { readFileSync, writeFileSync } from "node:fs";
import { argv, exit } from "node:process";
import { pathToFileURL } from "node:url";

const [folder] = argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
const python = await loadPyodide({ indexURL: folder, _makeSnapshot: true });
python.unpackArchive(new Uint8Array(readFileSync(`${folder}/satviz.zip`)), "zip", { extractDir: "/satviz" });
python.runPython("import sys; sys.path.append('/satviz')");
python.runPython(readFileSync(0, "utf8"));
writeFileSync(`${folder}/memory`, python.makeMemorySnapshot());
exit(0);
