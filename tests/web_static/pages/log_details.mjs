// The details of a row of the log as words, without a page. Run by test_log_details.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { serveReference } from "../served.mjs";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
await serveReference(process.argv[2], process.argv[3]);
const { detailWords, whatWords } = await import(pathToFileURL(`${process.argv[2]}/pages/log/log_details.js`));
const codes = new Map([[1, "P-001"]]);

assert.equal(detailWords({ patient: 1, session: 3 }, codes), "P-001 · session 3");
assert.equal(detailWords({ patient: 2 }, codes), "patient 2"); // who reads may not see this patient
assert.equal(detailWords({ role: "reviewer", patients: null }, codes), "role Reviewer");
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
// Measures of a trial, in their units; with all digits where fewer would hide the change.
assert.equal(
  detailWords({ trial: 4, before: { dist: 12.34 }, now: { dist: 12.56 } }, codes, "trial measured again"),
  "trial 4 · Distance driven: 12.34 m → 12.56 m",
);
assert.equal(
  detailWords({ before: { dist: 12.3401 }, now: { dist: 12.3402 } }, codes, "trial measured again"),
  "Distance driven: 12.3401 → 12.3402",
);
assert.equal(detailWords({}, codes), "");
assert.equal(whatWords("dial turned"), "speed dial turned");
assert.equal(whatWords("session viewed"), "session viewed");
assert.equal(whatWords("patient's screen paired"), "patient's screen paired");
assert.equal(whatWords("window cleaned"), "window cleaned"); // of a newer program
assert.equal(
  detailWords({ felt_change: 0.023, unused: ["right_elbow_3"] }, codes),
  "felt change 2 % · sensors not used right elbow 3",
);
assert.equal(detailWords({ how: "set-up", end: "by hand" }, codes), "by set-up · end ended by hand");
console.log("the words of details hold");
