// The messages of a phone, in hex. Run by test_phone_samples.py with the folder js and a file of samples.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, file] = process.argv.slice(2);
const { sampleOf } = await import(pathToFileURL(`${folder}/phone/sample.js`));
const given = JSON.parse(readFileSync(file, "utf8"));
const hex = ([page, seq, sent, angles]) => Buffer.from(sampleOf(page, seq, sent, angles)).toString("hex");
console.log(JSON.stringify(given.map(hex)));
