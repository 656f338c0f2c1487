// What the person before a camera shall change. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { adviceOn, steadyAdvice } = await import(pathToFileURL(`${process.argv[2]}/camera/placement.js`));

// A person in the middle of the picture; the changes are of single landmarks.
function seen(changes = {}, { width = 0.3, visibility = 0.95 } = {}) {
  const picture = Array.from({ length: 33 }, () => ({ x: 0.5, y: 0.5, z: 0, visibility }));
  Object.assign(picture[0], { y: 0.3 });
  Object.assign(picture[11], { x: 0.5 + width / 2 });
  Object.assign(picture[12], { x: 0.5 - width / 2 });
  for (const [i, change] of Object.entries(changes)) Object.assign(picture[i], change);
  return { picture, world: picture };
}

assert.equal(adviceOn(seen()), "good");
assert.equal(adviceOn(null), "lost");
assert.equal(adviceOn({ picture: [], world: [] }), "lost");
assert.equal(adviceOn(seen({ 12: { visibility: 0.3 } })), "lost");
assert.equal(adviceOn(seen({}, { width: 0.55 })), "back");
assert.equal(adviceOn(seen({ 0: { y: 0.01 } })), "back", "the head touches the rim");
assert.equal(adviceOn(seen({ 11: { x: 1.02 } })), "back", "a shoulder is outside");
const below = { y: 1.1, visibility: 0.2 };
assert.equal(adviceOn(seen({ 13: below, 14: below })), "back", "both elbows are below the picture");
assert.equal(adviceOn(seen({ 13: below })), "good", "an arm may be away");
assert.equal(adviceOn(seen({}, { visibility: 0.6 })), "light");
assert.equal(adviceOn(seen({ 0: { visibility: undefined } })), "light");

const give = steadyAdvice();
assert.equal(give("lost", 0), "lost");
assert.equal(give("good", 100), "lost");
assert.equal(give("good", 590), "lost");
assert.equal(give("good", 600), "good");
assert.equal(give("light", 700), "good");
assert.equal(give("good", 800), "good", "one flicker says nothing");
assert.equal(give("back", 900), "good");
assert.equal(give("back", 1400), "back");
assert.equal(give("lost", 1410), "lost", "that the chair stops is said at once");
assert.equal(give("good", 1420), "lost");
console.log("advice to the person before a camera holds");
