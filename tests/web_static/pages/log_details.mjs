// The details of a row of the log as words, without a page. Run by test_log_details.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { detailWords } = await import(pathToFileURL(`${process.argv[2]}/pages/log/log_details.js`));
const codes = new Map([[1, "P-001"]]);

assert.equal(detailWords({ patient: 1, session: 3 }, codes), "P-001 · session 3");
assert.equal(detailWords({ patient: 2 }, codes), "patient 2"); // who reads may not see this patient
assert.equal(detailWords({ role: "reviewer", patients: null }, codes), "role reviewer");
assert.equal(
  detailWords({ before: { forward: 1.5, turn: 1.2 }, now: { forward: 1.25, turn: 1.2 } }, codes),
  "forward 1.5 to 1.25",
);
assert.equal(detailWords({ name: "Ben", before: { role: "reviewer", patients: [1] }, now: { role: "reviewer", patients: null } }, codes),
  "name Ben · patients 1 to none");
assert.equal(detailWords({ has_folder: true, rows: { trial: 2 } }, codes), "has folder yes · rows trial 2");
assert.equal(detailWords({}, codes), "");
console.log("the words of details hold");
