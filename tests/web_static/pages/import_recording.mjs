// What the page of an import asks, and when its recording becomes the shirt. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { importStore } = await import(pathToFileURL(`${process.argv[2]}/pages/import_recording/store.js`));

const COLUMNS = ["a", "b"].map((name) => ({ name, role: "channel", joint: "body", least: 0, most: 1 }));
const OVERVIEW = { columns: COLUMNS, problem: "" };

/** A page whose requests wait until they are answered. */
function opened() {
  const page = { asked: [], used: [], gone: [], leave: new AbortController() };
  const apiOf = (session) => ({
    call: (_method, path, sent) =>
      new Promise((answer, refuse) =>
        page.asked.push({ session, path, options: JSON.parse(sent.get("options")), answer, refuse }),
      ),
    put: async (path, body) => void page.used.push({ session, path, file: body.file }),
  });
  const app = { api: apiOf(1), toasts: { show: () => {} }, go: (place) => page.gone.push(place) };
  page.store = importStore(app, page.leave.signal);
  page.anotherSession = () => (app.api = apiOf(2));
  return page;
}

/** @param {ReturnType<typeof opened>} page @param {unknown} answer */
async function answer(page, answer) {
  page.asked.at(-1).answer(answer);
  await new Promise(setImmediate);
}

const file = new File(["t,a,b"], "arm.csv");

// A correction that could not be read leaves what was shown, but it cannot be stored.
const corrected = opened();
corrected.store.choose([file]);
await answer(corrected, OVERVIEW);
assert.ok(corrected.store.isRead.value);
corrected.store.correct({ unit: "ms" });
assert.ok(!corrected.store.isRead.value);
corrected.asked.at(-1).refuse(new Error("The server is busy."));
await new Promise(setImmediate);
assert.equal(corrected.store.overview.value, OVERVIEW);
assert.ok(!corrected.store.isRead.value && !corrected.store.isReading.value);

// A column that becomes the time is no channel any more.
const timed = opened();
timed.store.choose([file]);
await answer(timed, OVERVIEW);
timed.store.setJoint("a", "trunk");
timed.store.correct({ time: "a" });
assert.deepEqual(timed.asked.at(-1).options.channels, [{ column: "b", joint: "body" }]);

// Without a file, the answer on the one before is not shown.
const emptied = opened();
emptied.store.choose([file]);
emptied.store.choose([]);
await answer(emptied, OVERVIEW);
assert.equal(emptied.store.overview.value, null);
assert.ok(!emptied.store.isReading.value);

// The recording becomes the shirt of the session whose page this is, and of none once the page was left.
for (const isLeft of [false, true]) {
  const page = opened();
  page.store.choose([file]);
  await answer(page, OVERVIEW);
  const stored = page.store.store(true);
  page.anotherSession();
  if (isLeft) page.leave.abort();
  await answer(page, { name: "arm.parquet" });
  await stored;
  assert.ok(page.asked.every(({ session }) => session === 1));
  assert.deepEqual(page.used, isLeft ? [] : [{ session: 1, path: "/equipment/shirt", file: "arm.parquet" }]);
  assert.deepEqual(page.gone, isLeft ? [] : ["#/shirt"]);
}
console.log("the page of an import holds");
