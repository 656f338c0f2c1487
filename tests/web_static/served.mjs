// Gives the modules of web_static/js the reference that the server serves, from a file.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

export async function serveReference(folder, file) {
  const answered = JSON.parse(readFileSync(file, "utf8"));
  globalThis.fetch = async () => ({ ok: true, json: async () => answered });
  const { readReference } = await import(pathToFileURL(`${folder}/reference.js`));
  await readReference();
}
