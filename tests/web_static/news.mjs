// Which news concerns a page, and what a page does after it, without a page. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { concerns, onNews } = await import(pathToFileURL(`${process.argv[2]}/live/news.js`));

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

// After news, until the page is left; also after what came while it read its first answers.
const page = (earlyNews) => ({ live: new EventTarget(), earlyNews });
const say = ({ live }, detail) => live.dispatchEvent(Object.assign(new Event("changed"), { detail }));
let times = 0;
const [app, left] = [page([news("disk")]), new AbortController()];
onNews(app, left.signal, ofTrial, () => times++);
assert.equal(times, 0);
say(app, news("trial", { trial: 9 }));
say(app, news("trial", { trial: 8 }));
assert.equal(times, 1);
left.abort();
say(app, news("trial", { trial: 9 }));
assert.equal(times, 1);
onNews(page([news("trial", { trial: 9 }), news("trial")]), new AbortController().signal, ofTrial, () => times++);
assert.equal(times, 2);
onNews(page(null), new AbortController().signal, ofTrial, () => times++); // the page is shown
assert.equal(times, 2);
console.log("the conditions of news hold");
