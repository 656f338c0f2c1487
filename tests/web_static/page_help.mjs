/** Every page that has an address of its own, with its help: three sentences and a drawing. */
import assert from "node:assert/strict";

const [folder] = process.argv.slice(2);
const { PAGES } = await import(`${folder}/shell/rail.js`);
const { pageWords } = await import(`${folder}/help/help_words.js`);
const { hasDrawing } = await import(`${folder}/help/drawings.js`);

for (const page of PAGES) {
  assert.equal(pageWords(page)?.sentences.length, 3, `${page}: three sentences are missing in texts/en/help.js`);
  assert.ok(hasDrawing(page), `${page}: its drawing is missing in help/drawings.js`);
  for (const sentence of pageWords(page)?.sentences ?? []) assert.match(sentence, /^\P{Ll}.*\.$/u);
}
assert.equal(pageWords("nowhere"), null);
console.log(`${PAGES.length} pages hold`);
