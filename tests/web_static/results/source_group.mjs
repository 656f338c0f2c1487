// Which group of trials a review shows first, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { firstGroup } = await import(pathToFileURL(`${process.argv[2]}/results/source_group.js`));

const trials = (...simulated) => simulated.map((one) => ({ source: { simulated: one } }));

assert.equal(firstGroup(trials(true, true)), "simulated"); // a clinic that only practised: no empty page comes first
assert.equal(firstGroup(trials(false, true)), "worn");
assert.equal(firstGroup(trials(null, true)), "simulated");
assert.equal(firstGroup(trials(true, null)), "unknown");
console.log("the first group holds");
