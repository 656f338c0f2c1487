/** Print the sentences of each forecast in a file, as JSON. */
import { readFileSync } from "node:fs";

const [folder, file] = process.argv.slice(2);
const { expectedWords } = await import(`${folder}/pages/calibrate/expected_words.js`);
console.log(JSON.stringify(JSON.parse(readFileSync(file, "utf8")).map(expectedWords)));
