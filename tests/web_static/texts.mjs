/** Print the texts of a language by file and id as JSON: of each message all its variants, with {names} of its values. */
import { readdirSync, readFileSync } from "node:fs";

const [modules, language] = process.argv.slice(2);
const { FluentResource } = await import(`${modules}/../vendor/@fluent/bundle/index.js`);

/** The words of a pattern, or of a part of one. */
function words(part) {
  if (typeof part === "string") return part;
  if (Array.isArray(part)) return part.map(words).join("");
  if (part.type === "select") return part.variants.map(({ value }) => words(value)).join(" ");
  return part.type === "var" ? `{${part.name}}` : part.value;
}

const texts = {};
for (const file of readdirSync(language).filter((name) => name.endsWith(".ftl"))) {
  const { body } = new FluentResource(readFileSync(`${language}/${file}`, "utf8"));
  texts[file] = Object.fromEntries(body.map(({ id, value }) => [id, words(value)]));
}
console.log(JSON.stringify(texts));
