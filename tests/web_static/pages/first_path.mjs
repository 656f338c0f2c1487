// Which path Review shows first, and what it says of a task without a verdict. Run by test_first_path.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const at = (file) => import(pathToFileURL(`${process.argv[2]}/pages/review/${file}`));
const { firstPath, pathsOf } = await at("path_choice.js");
const { countWords } = await at("session_verdicts.js");

const trial = (path, day, more = {}) => ({
  floorplan: "clinic", floorplan_title: "Clinic", path, kept: true, source: { simulated: false }, measures: { reached: true },
  started: `2026-11-${day}T10:00:00Z`, ...more,
});
const times = (count, path, day, more) => Array.from({ length: count }, () => trial(path, day, more));
const first = (trials) => firstPath(pathsOf(trials), trials).name;

const compared = [...times(4, "straight", 11), ...times(4, "straight", 18)];
assert.equal(first([...compared, ...times(3, "door", 18)]), "straight"); // the door was driven last
assert.equal(first([...compared, ...times(4, "door", 18), ...times(4, "door", 25)]), "door");
const unknown = { source: { simulated: null } }; // of an older program
assert.equal(first([...times(4, "straight", 11, unknown), ...times(4, "straight", 18, unknown), trial("door", 18, unknown)]), "straight");
const enough = [...times(6, "straight", 11), ...times(5, "straight", 18)]; // 3 and 2 trials that count
assert.equal(first([...enough, ...times(4, "door", 18), ...times(4, "door", 25)]), "straight"); // the door: "too few trials"
assert.equal(first([...enough, ...times(5, "door", 18), ...times(6, "door", 25)]), "door");
assert.equal(first([...times(4, "straight", 11), ...times(4, "straight", 18, { kept: false }), trial("door", 18)]), "door");
// How often the goal was reached is compared, too; a trial that was not measured is not.
assert.equal(first([...times(4, "straight", 11), ...times(4, "straight", 18, { measures: { reached: false } }), trial("door", 18)]), "straight");
assert.equal(first([...times(4, "straight", 11), ...times(4, "straight", 18, { measures: null }), trial("door", 18)]), "door");
// To get used to a task is of its first two days; a discarded trial was practice, too.
const threes = [...times(3, "straight", 11), ...times(3, "straight", 12)];
assert.equal(first([...threes, ...times(3, "straight", 18), trial("door", 18)]), "door");
assert.equal(first([...threes, ...times(3, "straight", 18), ...times(2, "straight", 19), trial("door", 19)]), "straight");
assert.equal(first([...compared, ...times(3, "door", 11), ...times(3, "door", 12), ...times(3, "door", 18), ...times(2, "door", 19)]), "door");
assert.equal(first([...times(3, "straight", 11, { kept: false }), trial("straight", 11), ...times(4, "straight", 18), trial("door", 18)]), "straight");
assert.equal(first([...times(4, "straight", 11), ...times(4, "straight", 18, { source: { simulated: true } })]), "straight");

const used = { familiarisation: true, reached: true };
const counted = { familiarisation: false, reached: true };
assert.match(countWords([used, used, used]), /^No trial of this task can be compared yet \(3 driven\)/);
assert.match(countWords([used, counted, { familiarisation: false, reached: false }]), /^2 of the 3 trials of this task can be compared/);
assert.match(countWords([used, counted, used]), /^1 of the 3 trials of this task can be compared/);
assert.match(countWords([used, counted, counted, counted]), /^3 of the 4 trials of this task can be compared/);
console.log("the first path holds");
