// The words of verdicts, and how far an unfinished trial came, without a page. Run by test_modules.py with the
// folder js and a file that holds the reference of the server.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { serveReference } from "../served.mjs";

const [folder, file] = process.argv.slice(2);
const load = (name) => import(pathToFileURL(`${folder}/${name}`));
const { largeMeasures, nameOf } = await load("results/measures.js");
const { isFamiliarisation, verdictLine, verdictWords } = await load("results/verdict_words.js");
const { wayDone } = await load("results/way_done.js");

await serveReference(folder, file);
assert.equal(nameOf("e_diff"), "Area off the path");
assert.equal(nameOf("reached"), "Goal reached");

const verdict = (word, more = {}) => ({ word, earlier: 3, later: 1.8, low: 2, high: 4.5, trials: 8, ...more });
const line = (name, found) => verdictLine(verdictWords(name, found));
assert.equal(line("e_diff", verdict("better")), "↓ −1.20 m² better than noise");
assert.equal(line("sparc", verdict("worse", { earlier: -2, later: -3 })), "↓ −1.00 worse than noise");
assert.equal(line("sparc", verdict("within", { earlier: -2.4, later: -2.42 })), "within noise");
assert.equal(line("e_diff", verdict("too few", { low: null, high: null })), "too few trials");
assert.deepEqual(verdictWords("e_diff", verdict("within")), {
  words: "within noise",
  arrow: "",
  amount: "",
  noise: "2.00 to 4.50 m²",
  tone: "",
});
assert.equal(verdictWords("e_diff", undefined), null);
assert.equal(isFamiliarisation({ earlier: 1, familiarisation: [2], verdicts: {} }, 2), true);
assert.equal(isFamiliarisation(null, 2), false);

// Large figures are of trials that count: neither discarded nor, where a part says nothing of the whole, unfinished.
const followed = { reached: true, follow_error_rms: 0.4, follow_near: 0.9, e_diff: 2 };
assert.deepEqual(largeMeasures({ kept: true, measures: followed }), ["follow_error_rms", "follow_near", "e_diff"]);
assert.deepEqual(largeMeasures({ kept: true, measures: { ...followed, reached: false } }), []);
assert.deepEqual(largeMeasures({ kept: false, measures: followed }), []);
assert.deepEqual(largeMeasures({ kept: true, measures: null }), []);

// A path that crosses itself: the chair stops at the crossing the first time.
const path = [
  [0, 0],
  [6, 0],
  [6, 4],
  [3, 4],
  [3, -4],
];
const driven = (places) => ({
  path,
  trajectory: { t: places.map((_, i) => i), x: places.map(([x]) => x), y: places.map(([, y]) => y) },
});
assert.deepEqual(
  wayDone(
    driven([
      [0, 0],
      [1, 0.2],
      [2, 0],
      [3, 0.1],
    ]),
  ),
  { done: 3, length: 21 },
);
assert.equal(
  wayDone(
    driven([
      [0, 0],
      [2, 0],
      [4, 0],
      [6, 0],
      [6, 2],
      [6, 4],
      [4, 4],
      [3, 3],
      [3, 1],
      [3, 0],
    ]),
  ).done,
  17,
);
assert.equal(wayDone({ path, trajectory: null }), null);
assert.equal(
  wayDone({
    path: [
      [1, 1],
      [1, 1],
    ],
    trajectory: { t: [0], x: [1], y: [1] },
  }),
  null,
);
console.log("verdict_words.mjs holds");
