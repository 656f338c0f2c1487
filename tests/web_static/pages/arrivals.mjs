// What the Shirt page says of what arrives. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { arrivalWords } = await import(pathToFileURL(`${process.argv[2]}/pages/shirt/arrival_words.js`));

const said = (verdict, camera = "") =>
  arrivalWords({ verdict, message: "What to do.", accepted: 0, left_out: 0 }, camera);
assert.equal(arrivalWords(null, ""), null);
assert.equal(said("senders"), null); // the sender's own card says it, with its button
assert.equal(said("arrives"), null);
assert.deepEqual(said("waiting"), { state: "waiting", words: "What to do." });
for (const verdict of ["rate", "partial", "moving", "nobody"])
  assert.deepEqual(said(verdict), { state: "wrong", words: "What to do." });
for (const verdict of ["nothing", "foreign", "refused", "late", "unplaced", "unopened", "gone", "ended"])
  assert.deepEqual(said(verdict), { state: "silent", words: "What to do." });
// Only the browser knows that it may not use its camera.
assert.match(said("nothing", "denied").words, /^The browser does not permit the camera/);
for (const camera of ["off", "asking", "preparing", "on", "unwanted"])
  assert.equal(said("nothing", camera).words, "What to do.");
console.log("what arrives holds");
