/** Print the word of each signal and of each spread in a file, as JSON. */
import { readFileSync } from "node:fs";
import { serveReference } from "./served.mjs";

const [folder, reference, file] = process.argv.slice(2);
await serveReference(folder, reference);
const { repeatsWord, signalWord } = await import(`${folder}/widgets/grade_words.js`);
const { signals, spreads } = JSON.parse(readFileSync(file, "utf8"));
console.log(JSON.stringify([signals.map(signalWord), spreads.map(repeatsWord)]));
