/** Print every text of the pages by its key, those of the page for tablets too, as JSON. */
import { readdirSync } from "node:fs";

const [folder] = process.argv.slice(2);
const texts = {};
for (const file of readdirSync(`${folder}/texts/en`, { recursive: true })) {
  if (!file.endsWith(".js")) continue; // a folder
  const { default: own } = await import(`${folder}/texts/en/${file}`);
  for (const [key, text] of Object.entries(own))
    texts[`${file}: ${key}`] = typeof text === "string" ? text : Object.values(text).join(" ");
}
console.log(JSON.stringify(texts));
