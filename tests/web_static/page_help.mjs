/**
 * Every page that has an address of its own has its module, its name, and, also below the Drive page, its help: three
 * sentences and a drawing.
 */
import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";

const [folder] = process.argv.slice(2);
const { PAGES } = await import(`${folder}/shell/pages.js`);
const { hasText } = await import(`${folder}/texts.js`);
const { helpName, pageWords } = await import(`${folder}/help/help_words.js`);
const { hasDrawing } = await import(`${folder}/help/drawings.js`);

const WITHOUT_ADDRESS = ["chair", "invitation", "set_up", "sign_in"]; // below Drive, and before the sign-in

const pages = Object.keys(PAGES);
const others = readdirSync(`${folder}/pages`).filter((name) => !pages.includes(name));
assert.deepEqual(others.sort(), WITHOUT_ADDRESS, "a folder of pages/ has no line in shell/pages.js");
for (const page of pages) {
  assert.ok(existsSync(`${folder}/pages/${page}/${page}.js`), `${page}: there is no pages/${page}/${page}.js`);
  assert.ok(hasText(`rail-${page}`), `${page}: its name is missing in words/en, as rail-${page.replaceAll("_", "-")}`);
  const step = PAGES[page].below;
  assert.ok(step === undefined || PAGES[step]?.icon, `${page}: there is no step ${step} in shell/pages.js`);
}
const below = ["tasks", "chairs", "screen", "chair", "over"].map((name) => `drive.${name}`);
for (const page of [...pages, ...below]) {
  assert.equal(pageWords(page)?.sentences.length, 3, `${page}: three sentences are missing in words/en/help.ftl`);
  assert.ok(hasDrawing(page), `${page}: its drawing is missing in help/drawings.js`);
  for (const sentence of pageWords(page)?.sentences ?? []) assert.match(sentence, /^\P{Ll}.*\.$/u);
}
assert.equal(pageWords("nowhere"), null);
assert.equal(helpName({ page: "drive", rest: ["over", "12"] }), "drive.over");
assert.equal(helpName({ page: "drive", rest: ["task", "door.hard", "aside"] }), "drive");
assert.equal(helpName({ page: "drive", rest: [] }), "drive");
assert.equal(helpName({ page: "controls", rest: ["over"] }), "controls");
console.log(`${pages.length + below.length} pages hold`);
