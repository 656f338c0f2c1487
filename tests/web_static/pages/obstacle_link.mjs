// Where the main button of the Drive page leads before a trial can be started. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { wayBeforeDriving } = await import(pathToFileURL(`${process.argv[2]}/pages/drive/obstacle_link.js`));
const shirt = { kind: "udp" };
const message = "The patient was calibrated in another shirt: calibrate in this one first.";

assert.equal(wayBeforeDriving(shirt, null), null); // the button starts the trial
assert.deepEqual(wayBeforeDriving(shirt, { message, page: "calibrate" }), {
  href: "#/calibrate",
  go: "Calibrate",
  message,
});
assert.equal(wayBeforeDriving(shirt, { message, page: "controls" }).href, "#/controls");
assert.equal(wayBeforeDriving(null, { message, page: "shirt" }).go, "Choose a shirt");
console.log("the way before driving holds");
