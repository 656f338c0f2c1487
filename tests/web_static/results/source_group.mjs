// Which group of trials a review shows first, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { firstGroup } = await import(pathToFileURL(`${process.argv[2]}/results/source_group.js`));

const trials = (...groups) => groups.map((group) => ({ source: { group } }));

assert.equal(firstGroup(trials("simulated", "simulated")), "simulated"); // a clinic that only practised: no empty page comes first
assert.equal(firstGroup(trials("worn", "simulated")), "worn");
assert.equal(firstGroup(trials("unknown", "simulated")), "simulated");
assert.equal(firstGroup(trials("simulated", "unknown")), "unknown");
assert.equal(firstGroup(trials("simulated", "camera")), "camera");
console.log("the first group holds");
