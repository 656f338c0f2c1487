// The range of an axis, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { extent } = await import(pathToFileURL(`${process.argv[2]}/charts/extent.js`));

/** The share of the axis between the least and the greatest value. */
const filled = (values, isFromZero) => {
  const [low, high] = extent(values, isFromZero);
  const least = isFromZero ? Math.min(0, ...values) : Math.min(...values);
  assert.ok(low < least && Math.max(...values) < high, `${values} lie inside of ${[low, high]}`);
  return (Math.max(...values) - least) / (high - low);
};

for (const values of [
  [3, 4],
  [0.81, 0.84, 0.8],
  [-2.4, -2.42],
  [1e-6, 3e-6],
  [-1, 1],
]) {
  assert.ok(filled(values, false) > 0.75, `${values} fill the axis`);
  assert.ok(filled(values.map(Math.abs), true) > 0.75, `${values} fill the axis from 0`);
}
// One trial stands in the middle of the axis; from 0 on it stands near the top.
const [low, high] = extent([5], false);
assert.equal((low + high) / 2, 5);
assert.ok(high - low < 5);
assert.ok(filled([5], true) > 0.8);
// So do values that differ by an error of rounding: between the ends of an axis there are numbers to write.
const [lowest, highest] = extent([5, 5 + 1e-15], false);
assert.ok(highest - lowest > 1);
for (const none of [[], [NaN, Infinity]]) assert.equal(extent(none, true), undefined);
for (const isFromZero of [true, false]) {
  const [least, greatest] = extent([0, 0, NaN], isFromZero);
  assert.ok(least < 0 && greatest > 0 && Number.isFinite(greatest - least));
}
console.log("extent.mjs holds");
