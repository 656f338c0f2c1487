// Which large word the patient's screen shows, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { momentWords } = await import(pathToFileURL(`${process.argv[2]}/patient/moment_word.js`));

const TICK = 50; // ms between two messages
const nothing = { state: "disarmed", cue: null, trial: null, drives: false, over: null };
const driving = (id, state) => ({ ...nothing, state, trial: { id }, drives: true });

/** The words of messages, each sent for some ms; a word that stays is listed once. */
function wordsOf(...messages) {
  const word = momentWords();
  const words = [];
  let time = 0;
  for (const [message, length] of messages) {
    for (const end = time + length; time < end; time += TICK) {
      const now = word(message, time);
      if (now !== words.at(-1)) words.push(now);
    }
  }
  return words;
}

const byHand = { id: 7, end: "by hand" };
const atGoal = { id: 7, end: "goal" };
const start = [
  [nothing, 200],
  [driving(7, "checking"), 1000],
];
const drive = [...start, [driving(7, "armed"), 3000]];

assert.deepEqual(
  wordsOf(...drive, [{ ...driving(7, "armed"), over: atGoal }, 500], [{ ...nothing, over: atGoal }, 20_000]),
  ["", "rest", "go", "", "goal", ""],
);
// Ended while the controls were still checked for rest: the recording is closed in this state, then the chair is disarmed.
const ended = [...start, [{ ...driving(7, "checking"), over: byHand }, 500], [{ ...nothing, over: byHand }, 20_000]];
assert.deepEqual(wordsOf(...ended), ["", "rest", "ended", ""]);
// Ended while it was stopped: the stop has the screen until it is taken back.
const stopped = { ...driving(7, "fault"), over: byHand };
assert.deepEqual(wordsOf(...drive, [stopped, 1000], [{ ...nothing, over: byHand }, 20_000]), [
  "",
  "rest",
  "go",
  "",
  "ended",
  "",
]);
// The next trial, or a drive of a real chair, begins soon after: what is done now counts.
for (const next of [driving(8, "checking"), { ...nothing, state: "checking", drives: true }]) {
  const words = wordsOf(...ended.slice(0, -1), [{ ...nothing, over: byHand }, 500], [{ ...next, over: byHand }, 500]);
  assert.deepEqual(words, ["", "rest", "ended", "rest"]);
}
// A page that is opened after the end says nothing about it.
assert.deepEqual(wordsOf([{ ...nothing, over: byHand }, 1000]), [""]);
console.log("the word of each moment holds");
