// Numbers, lists, times, days and sizes as people read them in the language of the modules. Run by test_modules.py with
// the folder js, in a time zone west of Greenwich.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const folder = process.argv[2];
const { LANGUAGE } = await import(pathToFileURL(`${folder}/language.js`));
const format = await import(pathToFileURL(`${folder}/widgets/format.js`));

const year = new Date().getFullYear();
const EXPECTED = {
  en: {
    lists: ["a", "a and b", "a, b and c", "a, b or c"],
    days: ["Nov 26, 2026", "Nov 25, 2026"],
    moments: ["Nov 26, 23:41", `Nov 26, ${year - 1}, 23:41`, "Jan 1, 2001, 12:05", `Nov 26, ${year}, 23:41`],
    exact: `Nov 26, ${year}, 23:41:07`,
  },
  es: {
    lists: ["a", "a y b", "a, b y c", "a, b o c"],
    days: ["26 nov 2026", "25 nov 2026"],
    moments: ["26 nov, 23:41", `26 nov ${year - 1}, 23:41`, "1 ene 2001, 12:05", `26 nov ${year}, 23:41`],
    exact: `26 nov ${year}, 23:41:07`,
  },
  de: {
    lists: ["a", "a und b", "a, b und c", "a, b oder c"],
    days: ["26. Nov. 2026", "25. Nov. 2026"],
    moments: ["26. Nov., 23:41", `26. Nov. ${year - 1}, 23:41`, "1. Jan. 2001, 12:05", `26. Nov. ${year}, 23:41`],
    exact: `26. Nov. ${year}, 23:41:07`,
  },
}[LANGUAGE];
const point = LANGUAGE === "en" ? "." : ",";

/** Check a text whose decimals are written here with a point. */
const reads = (text, expected) => assert.equal(text, expected.replaceAll(".", point));

const { number, signed, percent, signedPercent, ofFull, significant, unrounded } = format;
reads(number(1.005, 2), "1.00"); // as toFixed rounds
reads(number(-0.04, 1), "0.0");
reads(number(-12345.678, 1), "−12345.7");
reads(number(0.5, 0), "1");
for (const none of [null, undefined, NaN, Infinity]) assert.equal(number(none, 1), "–");
assert.deepEqual([signed(0.04, 1), signed(0.05, 1), signed(-2, 0)].join(" "), `0${point}0 +0${point}1 −2`);
assert.deepEqual([percent(0.784), percent(-0.05), percent(null)], ["78 %", "−5 %", "–"]);
assert.deepEqual([signedPercent(0.05), signedPercent(-0.05)], ["+5 %", "−5 %"]);
reads(ofFull(0.0512, "% / s"), "5.1 % / s");
reads(significant(1234.5678, 6), "1234.57");
reads(significant(0.0000012, 3), "0.0000012");
reads(unrounded(0.25), "0.25");
reads(unrounded(-20000), "−20000");
assert.equal(format.clock(125), "2:05");

const { allOf, anyOf } = format;
assert.deepEqual([allOf(["a"]), allOf(["a", "b"]), allOf(["a", "b", "c"]), anyOf(["a", "b", "c"])], EXPECTED.lists);

const { day, dayAndTime, exactMoment, moment, minuteOfDay, timeOfDay } = format;
assert.equal(new Date("2026-11-26T00:00:00Z").getDate(), 25, "the script runs west of Greenwich");
// A day that somebody entered is this day everywhere.
assert.deepEqual([day("2026-11-26"), day("2026-11-26T02:00:00+00:00")], EXPECTED.days);
assert.deepEqual(
  [
    moment(`${year}-11-26T23:41:00`),
    moment(`${year - 1}-11-26T23:41:00`),
    dayAndTime("2001-01-01T12:05:00"), // also of a clock that is wrong by years
    dayAndTime(Date.parse(`${year}-11-26T23:41:00`)),
  ],
  EXPECTED.moments,
);
assert.equal(exactMoment(`${year}-11-26T23:41:07`), EXPECTED.exact);
assert.equal(minuteOfDay("2026-11-26T08:05:00"), "08:05");
assert.equal(timeOfDay(Date.parse("2026-11-26T18:05:09")), "18:05:09");

const sizes = { 1: "1 kB", 999_400: "999 kB", 999_960: "1.0 MB", 48_000_000: "48.0 MB", 12_000_000_000: "12.0 GB" };
for (const [bytes, words] of Object.entries(sizes)) reads(format.size(Number(bytes)), words);
console.log("numbers, lists, times, days and sizes hold");
