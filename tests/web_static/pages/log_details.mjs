// The details of a row of the log as words, without a page. Run by test_log_details.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
const { detailWords, whatWords } = await import(pathToFileURL(`${process.argv[2]}/pages/log/log_details.js`));
const codes = new Map([[1, "P-001"]]);

assert.equal(detailWords({ patient: 1, session: 3 }, codes), "P-001 · session 3");
assert.equal(detailWords({ patient: 2 }, codes), "patient 2"); // who reads may not see this patient
assert.equal(detailWords({ role: "reviewer", patients: null }, codes), "role reviewer");
assert.equal(
  detailWords({ before: { forward: 1.5, turn: 1.2 }, now: { forward: 1.25, turn: 1.2 } }, codes),
  "Forward speed: 1.50 → 1.25 m/s",
);
// A limit of turning is written in degrees per second, with as many digits as show the change.
assert.equal(detailWords({ before: { turn: 1.2 }, now: { turn: 1.0 } }, codes), "Turn speed: 69 → 57 °/s");
assert.equal(detailWords({ before: { turn: 1.2 }, now: { turn: 1.201 } }, codes), "Turn speed: 68.75 → 68.81 °/s");

assert.equal(
  detailWords(
    { name: "Ben", before: { role: "reviewer", patients: [1] }, now: { role: "reviewer", patients: null } },
    codes,
  ),
  "name Ben · patients: P-001 → all patients",
);
assert.equal(detailWords({ has_folder: true, rows: { trial: 2 } }, codes), "folder chosen yes · rows trial 2");
assert.equal(detailWords({ share: 0.5 }, codes, "dial turned"), "speed dial at 50 %");
assert.equal(detailWords({ share: 3, patient: 1 }, codes, "share viewed"), "P-001 · share link 3");
assert.equal(detailWords({ fault: "stop_tablet", trial: 4 }, codes), "reason Stop on the screen · trial 4");
assert.equal(
  detailWords({ consent: "clinic_prior", given: "2026-03-01" }, codes),
  "consent use for other patients of the clinic · given on Mar 1, 2026",
);
assert.equal(
  detailWords({ kind: "recording", size: 48_000_000, same_name: "keep-both" }, codes),
  "kind recording · size 48.0 MB · name that was taken both kept",
);
assert.equal(detailWords({ joint: "right_elbow", right: false }, codes), "joint right elbow · sits right no");
assert.equal(detailWords({}, codes), "");
assert.equal(whatWords("dial turned"), "speed dial turned");
assert.equal(whatWords("session viewed"), "session viewed"); // plain already
console.log("the words of details hold");
