// What stands along a learning curve, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
const { mapTraces, sessionShapes, sessionWords } = await import(
  pathToFileURL(`${process.argv[2]}/charts/curve_marks.js`)
);

const colours = { text: "rgb(1, 2, 3)", "path-prescribed": "rgb(4, 5, 6)" };
const row = (number, session, profile_version, origin) => ({ number, session, profile_version, origin });
// Trial 4 was discarded, and a map was made and taken back within the second session.
const rows = [
  row(1, 1, 1, "calibration"),
  row(2, 1, 1, "calibration"),
  row(3, 2, 1, "calibration"),
  row(5, 2, 2, "adaptation"),
  row(6, 2, 3, "back"),
  row(7, 3, 3, "back"),
];

const bands = sessionShapes(rows, colours);
assert.deepEqual(
  bands.map(({ x0, x1 }) => [x0, x1]),
  [
    [0.5, 2.5],
    [6.5, 7.5],
  ],
);
assert.deepEqual(
  sessionWords(rows).map(({ text, x }) => [text, x]),
  [
    ["session", 0],
    ["1", 1.5],
    ["2", 4.5],
    ["3", 7],
  ],
);
// With room for it, the word stands at each.
assert.deepEqual(
  sessionWords(rows.slice(0, 5)).map(({ text }) => text),
  ["session 1", "session 2"],
);
// On a telephone the word has no room at each of four.
const four = Array.from({ length: 8 }, (_, i) => row(i + 1, 1 + Math.floor(i / 2), 1, "calibration"));
assert.deepEqual(
  sessionWords(four).map(({ text }) => text),
  ["session", "1", "2", "3", "4"],
);
const many = Array.from({ length: 8 }, (_, i) => row(i + 1, i + 1, 1, "calibration"));
assert.deepEqual(
  sessionWords(many)
    .map(({ text }) => text)
    .slice(0, 3),
  ["session", "1", "2"],
);

const maps = mapTraces(rows, colours);
assert.deepEqual(
  maps.map(({ name, x, text }) => [name, x, text]),
  [
    ["calibrated", [1], ["1"]],
    ["calibration adapted", [5], ["2"]],
    ["calibration restored", [6], ["3"]],
  ],
);
assert.match(maps[1].hovertemplate[0], /^Calibration 2, adapted: from trial 5 on/);
// Where numbers would stand on one another only the last of them is written; the marks are all there.
const crowded = Array.from({ length: 60 }, (_, i) => row(i + 1, 1, i + 1, i ? "adaptation" : "calibration"));
const [, adapted] = mapTraces(crowded, colours);
assert.equal(adapted.x.length, 59);
assert.deepEqual(adapted.text.filter(Boolean), ["60"]);
assert.deepEqual([mapTraces([], colours), sessionShapes([], colours), sessionWords([])], [[], [], []]);
console.log("curve_marks.mjs holds");
