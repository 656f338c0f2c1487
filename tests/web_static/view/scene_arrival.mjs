// When the canvas of the 3D view is shown. Run by test_scene_arrival.py with the folder js and the script of the view's page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";

let next = () => {};
let isShown = null;
const window = { addEventListener() {} };
const document = { documentElement: { toggleAttribute: (name, is) => name === "data-scene" && (isShown = is) } };
const requestAnimationFrame = (look) => (next = look);
class Document {}
runInNewContext(readFileSync(process.argv[3], "utf-8"), {
  window,
  document,
  requestAnimationFrame,
  Document,
  performance,
  setInterval() {},
});
const draw = (pictures) => {
  for (let i = 0; i < pictures; i++) next();
  return isShown;
};

assert.equal(draw(10), false); // viser's page has not started
window.__viserMutable = { nodePoseData: { "": {}, "/clock": {} } };
assert.equal(draw(10), false); // the scene has not arrived: only viser's own cross of axes could be seen
window.__viserMutable.nodePoseData["/world"] = {};
assert.equal(draw(1), false); // arrived, but not drawn yet
assert.equal(draw(5), true);
delete window.__viserMutable.nodePoseData["/world"]; // connected again: viser's page begins anew
assert.equal(draw(1), false);
console.log("the arrival of the scene holds");
