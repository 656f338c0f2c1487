// Which news concerns a page, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { concerns } = await import(pathToFileURL(`${process.argv[2]}/live/news.js`));

/** News as the server sends them: with null for an id that it does not name. */
const news = (what, ids = {}) => ({ what, patient: null, session: null, trial: null, ...ids });
const ofTrial = { what: ["trial"], patient: 1, session: 4, trial: 9 };

// By what changed.
assert.equal(concerns(news("equipment"), { what: ["controls", "equipment"] }), true);
assert.equal(concerns(news("disk"), { what: ["controls", "equipment"] }), false);
// By whom it concerns; an id that only one of both names decides nothing.
assert.equal(concerns(news("trial", { patient: 1, session: 4, trial: 9 }), ofTrial), true);
for (const other of [{ patient: 2 }, { session: 5 }, { trial: 8 }])
  assert.equal(concerns(news("trial", { patient: 1, session: 4, trial: 9, ...other }), ofTrial), false);
assert.equal(concerns(news("trial", { patient: 1 }), ofTrial), true);
assert.equal(concerns(news("trial"), ofTrial), true);
assert.equal(concerns(news("trial", { patient: 2, trial: 9 }), { what: ["trial"] }), true);
assert.equal(concerns(news("session", { patient: 1, session: 4 }), ofTrial), false);
// What the browser says itself.
assert.equal(concerns({ what: "everything" }, ofTrial), true);
assert.equal(concerns({ what: "everything" }, { what: [] }), true);
assert.equal(concerns({ what: "sign-in" }, ofTrial), false);
console.log("the conditions of news hold");
