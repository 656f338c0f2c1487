// What stands along a learning curve, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
const charts = pathToFileURL(`${process.argv[2]}/charts/`);
const { mapSeries, sessionBands, sessionRow, versionRow } = await import(`${charts}curve_marks.js`);
const { withRoom } = await import(`${charts}plot.js`);

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

assert.deepEqual(sessionBands(rows), [
  [0.5, 2.5],
  [6.5, 7.5],
]);
const { texts, beside } = sessionRow(rows);
assert.equal(beside, "session");
assert.deepEqual(
  texts.map(({ text, x }) => [text, x]),
  [
    ["1", 1.5],
    ["2", 4.5],
    ["3", 7],
  ],
);
/** The texts of a row. */
const written = (row) => row.texts.map(({ text }) => text);
// With room for it, the word stands at each.
const two = sessionRow(rows.slice(0, 5));
assert.deepEqual([two.beside, ...written(two)], [undefined, "session 1", "session 2"]);
// On a telephone the word has no room at each of four.
const four = Array.from({ length: 8 }, (_, i) => row(i + 1, 1 + Math.floor(i / 2), 1, "calibration"));
assert.deepEqual(written(sessionRow(four)), ["1", "2", "3", "4"]);

const maps = mapSeries(rows, "red");
assert.deepEqual(
  maps.map(({ name, x }) => [name, x]),
  [
    ["calibrated", [1]],
    ["calibration adapted", [5]],
    ["calibration restored", [6]],
  ],
);
assert.match(maps[1].words(0), /^Calibration 2, adapted: from trial 5 on/);
assert.deepEqual(versionRow(rows).texts, [
  { x: 1, text: "1" },
  { x: 5, text: "2" },
  { x: 6, text: "3" },
]);
assert.deepEqual(
  [mapSeries([], "red"), sessionBands([]), written(sessionRow([])), written(versionRow([]))],
  [[], [], [], []],
);
assert.equal(sessionRow([]).beside, undefined);

// Where texts would stand on one another only the last of them is written.
const crowded = Array.from({ length: 60 }, (_, i) => ({ left: 6 * i, width: 14 }));
const shown = withRoom(crowded);
assert.equal(shown[0], crowded[59]);
assert.ok(shown.length > 10);
assert.ok(shown.every(({ left }, i) => i === 0 || left + 14 < shown[i - 1].left));
const apart = [
  { left: 0, width: 10 },
  { left: 20, width: 10 },
];
assert.deepEqual(withRoom(apart), apart.toReversed());
console.log("curve_marks.mjs holds");
