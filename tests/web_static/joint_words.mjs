// What joints and sensors are called in the language of the modules. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const folder = process.argv[2];
const { LANGUAGE } = await import(pathToFileURL(`${folder}/language.js`));
const { jointLabel, jointWithin, labelsOf, labelWords, sensorName, sensorWithin } = await import(
  pathToFileURL(`${folder}/widgets/joint_words.js`)
);
const { gestureWithin, gestureWords } = await import(pathToFileURL(`${folder}/widgets/gestures.js`));

const { alone, within, sensor, bend, back } = {
  en: {
    alone: "Right elbow",
    within: "right elbow",
    sensor: "Right elbow 3",
    bend: "Right elbow: bent",
    back: "right elbow, going back, held",
  },
  es: {
    alone: "Codo derecho",
    within: "codo derecho",
    sensor: "Codo derecho 3",
    bend: "Codo derecho: flexión",
    back: "codo derecho, al volver, manteniendo",
  },
  de: {
    alone: "Rechter Ellbogen",
    within: "rechter Ellbogen",
    sensor: "Rechter Ellbogen 3",
    bend: "Rechter Ellbogen: gebeugt",
    back: "rechter Ellbogen, zurück, gehalten",
  },
}[LANGUAGE];

const usual = { name: "right_elbow", label: "Right elbow" };
assert.equal(jointLabel(usual), alone);
assert.equal(jointWithin(usual), within);
assert.equal(jointWithin({ name: "right_elbow", label: alone }), within); // its label was translated before
for (const own of [
  { name: "right_elbow", label: "Elbow with the splint" },
  { name: "left_ear", label: "Left ear" },
])
  assert.deepEqual([jointLabel(own), jointWithin(own)], [own.label, own.label]);

assert.deepEqual([labelWords("Right elbow"), labelWords("Left ear")], [alone, "Left ear"]);
assert.equal(sensorName("right_elbow_3"), sensor);
assert.equal(sensorWithin("right_elbow_3"), sensor.replace(alone, within));
assert.equal(sensorName("right_elbow_bend"), bend);
assert.equal(sensorWithin("right_elbow_bend"), bend.replace(alone, within));
assert.equal(sensorName("right_elbow_top"), "right elbow top");
assert.equal(sensorName("C7_left"), "C7 left");

const labels = labelsOf([usual]);
const gesture = { joint: "right_elbow", direction: 1, feature: "rate" };
assert.equal(gestureWords(gesture, labels), alone);
assert.equal(gestureWithin(gesture, labels), within);
assert.equal(gestureWithin({ ...gesture, direction: -1, feature: "displacement" }, labels), back);
console.log("names of joints hold");
