// Where the main button of the Drive page leads before a trial can be started. Run by test_obstacle_link.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { wayBeforeDriving } = await import(pathToFileURL(`${process.argv[2]}/pages/drive/obstacle_link.js`));
const shirt = { kind: "udp" };
const words = "The patient was calibrated in another shirt: calibrate in this one first.";

assert.equal(wayBeforeDriving(shirt, null), null); // the button starts the trial
assert.deepEqual(wayBeforeDriving(shirt, { words, page: "calibrate" }), { href: "#/calibrate", go: "Calibrate", words });
assert.equal(wayBeforeDriving(shirt, { words, page: "controls" }).href, "#/controls");
assert.equal(wayBeforeDriving(null, { words, page: "shirt" }).go, "Choose a shirt");
console.log("the way before driving holds");
