/** Print what is said of each list of screens in a file, as JSON. */
import { readFileSync } from "node:fs";

const [folder, file] = process.argv.slice(2);
const { screenWords } = await import(`${folder}/pages/drive/screen_words.js`);
console.log(JSON.stringify(JSON.parse(readFileSync(file, "utf8")).map(screenWords)));
