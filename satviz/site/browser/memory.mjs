// Run by Node when a site is built: Python with satviz and its first scene, kept as the memory it has then.
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`).href);
const python = await loadPyodide({ indexURL: folder, _makeSnapshot: true });
python.unpackArchive(new Uint8Array(readFileSync(`${folder}/satviz.zip`)), "zip", { extractDir: "/satviz" });
python.runPython("import sys; sys.path.append('/satviz')");
python.runPython(readFileSync(0, "utf8"));
writeFileSync(`${folder}/memory`, python.makeMemorySnapshot());
process.exit(0);
