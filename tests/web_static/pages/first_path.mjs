// Which path Review shows first, and what it says of a task without a verdict. Run by test_modules.py with the folder js and
// a file that holds the reference of the server.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { serveReference } from "../served.mjs";

const at = (file) => import(pathToFileURL(`${process.argv[2]}/pages/review/${file}`));
await serveReference(...process.argv.slice(2));
const { firstPath, pathsOf } = await at("path_choice.js");
const { countWords } = await at("session_verdicts.js");

const trial = (path, session, more = {}) => ({
  floorplan: "clinic",
  floorplan_title: "Clinic",
  path,
  source: { group: "worn" },
  compared_in: session,
  ...more,
});
const times = (count, path, session, more) => Array.from({ length: count }, () => trial(path, session, more));
const first = (trials) => firstPath(pathsOf(trials), trials).name;

const compared = [trial("straight", 1), trial("straight", 2)];
assert.equal(first([...compared, ...times(3, "door", 2)]), "straight"); // the door was driven last, in one session
assert.equal(first([...compared, trial("door", 2), trial("door", 3)]), "door");
const unknown = { source: { group: "unknown" } }; // of an older program
assert.equal(
  first([trial("straight", 1, unknown), trial("straight", 2, unknown), trial("door", 2, unknown)]),
  "straight",
);
const enough = [...times(3, "straight", 1), ...times(2, "straight", 2)];
assert.equal(first([...enough, ...times(2, "door", 2), ...times(2, "door", 3)]), "straight"); // the door: "too few trials"
assert.equal(first([...enough, ...times(2, "door", 2), ...times(3, "door", 3)]), "door");
// Which trials verdicts compare is the server's to say: others count for nothing.
assert.equal(first([...compared, ...times(9, "door", null), trial("door", 3)]), "straight");
const simulated = { source: { group: "simulated" } };
assert.equal(first([...compared, trial("door", 1), trial("door", 2, simulated)]), "straight"); // two sources

const used = { familiarisation: true, reached: true };
const counted = { familiarisation: false, reached: true };
assert.match(countWords([used, used, used]), /^No trial of this task can be compared yet \(3 driven\)/);
assert.match(
  countWords([used, counted, { familiarisation: false, reached: false }]),
  /^2 of the 3 trials of this task can be compared/,
);
assert.match(countWords([used, counted, used]), /^1 of the 3 trials of this task can be compared/);
assert.match(countWords([used, counted, counted, counted]), /^3 of the 4 trials of this task can be compared/);
console.log("the first path holds");
