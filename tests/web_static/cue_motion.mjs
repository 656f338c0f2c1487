// The ring and the disc of a cue for people who prefer reduced motion, and for the others. Run by test_modules.py
// with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const query = { matches: false };
globalThis.matchMedia = () => query;
const { discRadius, ringShare } = await import(pathToFileURL(`${process.argv[2]}/widgets/cue_circle.js`));
const SHARES = Array.from({ length: 101 }, (_, i) => i / 100);
const different = (values) => new Set(values).size;

assert.equal(different(SHARES.map(ringShare)), 101);
assert.equal(different(SHARES.map((share) => discRadius("move", share))), 101);
const [small, large] = [discRadius("move", 0), discRadius("move", 1)];
assert.ok(large > small);

query.matches = true;
assert.deepEqual([...new Set(SHARES.map(ringShare))], [0, 0.25, 0.5, 0.75, 1]);
assert.deepEqual([...new Set(SHARES.map((share) => discRadius("move", share)))], [small, large]);
assert.deepEqual([...new Set(SHARES.map((share) => discRadius("return", share)))], [large, small]);
assert.equal(discRadius("rest", 0.7), small);
console.log("cue_motion.mjs holds");
