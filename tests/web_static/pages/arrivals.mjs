// What the Shirt page says of what arrives, and which sensors move. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const from = (file) => import(pathToFileURL(`${process.argv[2]}/pages/shirt/${file}`));
const { arrivalWords } = await from("arrival_words.js");
const { movingChannels } = await from("moving_channels.js");

const said = (verdict, camera = "") =>
  arrivalWords({ verdict, message: "What to do.", accepted: 0, left_out: 0 }, camera);
assert.equal(arrivalWords(null, ""), null);
assert.equal(said("senders"), null); // the sender's own card says it, with its button
assert.deepEqual(said("arrives"), { state: "good", words: "What to do." });
assert.deepEqual(said("waiting"), { state: "waiting", words: "What to do." });
assert.deepEqual(said("rate"), { state: "wrong", words: "What to do." });
for (const verdict of ["nothing", "foreign", "refused", "late", "unplaced", "unopened", "gone", "ended"])
  assert.deepEqual(said(verdict), { state: "silent", words: "What to do." });
// Only the browser knows that it may not use its camera.
assert.match(said("nothing", "denied").words, /^The browser does not permit the camera/);
for (const camera of ["off", "asking", "preparing", "on", "unwanted"])
  assert.equal(said("nothing", camera).words, "What to do.");

const RATE = 20; // messages a second
const tremble = (i) => 0.001 * ((i * 7) % 5); // of a body at rest
let t = 100;
const see = movingChannels();
const during = (seconds, values, floors = [0, 0, 0]) => {
  let moving = [];
  for (let i = 0; i < seconds * RATE; i++) moving = see((t += 1 / RATE), values(i), floors);
  return moving;
};
const atRest = (i) => [tremble(i), tremble(i + 1), tremble(i + 2)];
assert.deepEqual(during(0.5, atRest), []);
assert.deepEqual(during(3, atRest), []);
assert.deepEqual(during(1, (i) => [tremble(i), 0.05 * i, 0.02 * i]), [1, 2]); // the one that moves most is first
assert.deepEqual(during(3, atRest), []);
assert.deepEqual(during(1, (i) => [tremble(i), 0.05 * i, tremble(i)], [2, 2, 2]), []); // within the noise of the sensors
assert.deepEqual(during(1, (i) => [null, 0.05 * i, tremble(i)]), [1]); // one without values
t += 10; // a pause: what is calm is found anew
assert.deepEqual(during(0.5, (i) => [5 * i, 5 * i, 5 * i]), []);
assert.deepEqual(during(2, (i) => [5 * i, 5 * i]), []); // another shirt
console.log("arrivals and movements hold");
