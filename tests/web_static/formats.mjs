// Times, days and sizes as people read them. Run by test_modules.py with the folder js, in a time zone west of Greenwich.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { day, dayAndTime, exactMoment, moment, size } = await import(
  pathToFileURL(`${process.argv[2]}/widgets/format.js`)
);

assert.equal(new Date("2026-11-26T00:00:00Z").getDate(), 25, "the script runs west of Greenwich");
assert.equal(day("2026-11-26"), "Nov 26, 2026"); // a day that somebody entered is this day everywhere
assert.equal(day("2026-11-26T02:00:00+00:00"), "Nov 25, 2026");
const year = new Date().getFullYear();
assert.equal(moment(`${year}-11-26T23:41:00`), "Nov 26, 23:41");
assert.equal(moment(`${year - 1}-11-26T23:41:00`), `Nov 26, ${year - 1}, 23:41`);
assert.equal(dayAndTime("2001-01-01T12:05:00"), "Jan 1, 2001, 12:05"); // also of a clock that is wrong by years
assert.equal(dayAndTime(Date.parse(`${year}-11-26T23:41:00`)), `Nov 26, ${year}, 23:41`);
assert.equal(exactMoment(`${year}-11-26T23:41:07`), `Nov 26, ${year}, 23:41:07`);
const sizes = { 1: "1 kB", 999_400: "999 kB", 999_960: "1.0 MB", 48_000_000: "48.0 MB", 12_000_000_000: "12.0 GB" };
for (const [bytes, words] of Object.entries(sizes)) assert.equal(size(Number(bytes)), words);
console.log("times, days and sizes hold");
