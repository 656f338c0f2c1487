// How old a picture may be, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { LOOK_EVERY, ageLimit } = await import(pathToFileURL(`${process.argv[2]}/view/picture_age.js`));

let now = 0;
performance.now = () => now;
const look = ageLimit();
const after = (ms) => {
  now += ms;
  return look();
};

for (let i = 0; i < 20; i += 1) assert.deepEqual(after(LOOK_EVERY), { onTime: true, limit: 1 });
// The page itself was late: what it shows may be there and only drawn late.
assert.deepEqual(after(800), { onTime: false, limit: 3 });
for (let i = 0; i < 11; i += 1) assert.deepEqual(after(LOOK_EVERY), { onTime: true, limit: 3 });
assert.deepEqual(after(LOOK_EVERY), { onTime: true, limit: 1 });
console.log("the limit of age holds");
