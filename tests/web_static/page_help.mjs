/** Every page that has an address of its own, also below the Drive page, with its help: three sentences and a drawing. */
import assert from "node:assert/strict";

const [folder] = process.argv.slice(2);
const { PAGES } = await import(`${folder}/shell/rail.js`);
const { helpName, pageWords } = await import(`${folder}/help/help_words.js`);
const { hasDrawing } = await import(`${folder}/help/drawings.js`);

const below = ["tasks", "chairs", "screen", "chair", "over"].map((name) => `drive.${name}`);
for (const page of [...PAGES, ...below]) {
  assert.equal(pageWords(page)?.sentences.length, 3, `${page}: three sentences are missing in words/en/help.ftl`);
  assert.ok(hasDrawing(page), `${page}: its drawing is missing in help/drawings.js`);
  for (const sentence of pageWords(page)?.sentences ?? []) assert.match(sentence, /^\P{Ll}.*\.$/u);
}
assert.equal(pageWords("nowhere"), null);
assert.equal(helpName({ page: "drive", rest: ["over", "12"] }), "drive.over");
assert.equal(helpName({ page: "drive", rest: ["task", "door.hard", "aside"] }), "drive");
assert.equal(helpName({ page: "drive", rest: [] }), "drive");
assert.equal(helpName({ page: "controls", rest: ["over"] }), "controls");
console.log(`${PAGES.length + below.length} pages hold`);
