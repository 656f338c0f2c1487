// Writes the sentences of differences as JSON. Run by test_difference_words.py with the folder js and the differences.
import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
globalThis.document ??= { addEventListener() {}, querySelector: () => null };
const { differenceWords } = await import(pathToFileURL(`${process.argv[2]}/pages/chair/difference_words.js`));

const sets = JSON.parse(await readFile(process.argv[3], "utf8"));
process.stdout.write(JSON.stringify(sets.map((differences) => differences.map(differenceWords))));
