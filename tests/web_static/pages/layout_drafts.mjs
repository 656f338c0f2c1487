// The unsaved changes of layouts that a tab keeps. Run by test_modules.py with the folder js.
import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const kept = new Map();
globalThis.sessionStorage = {
  getItem: (key) => kept.get(key) ?? null,
  setItem: (key, text) => void kept.set(key, text),
  removeItem: (key) => void kept.delete(key),
};
const { forgetDraft, readDraft, storeDraft } = await import(
  pathToFileURL(`${process.argv[2]}/pages/layouts/draft_store.js`)
);
const layout = (name) => ({ name, channels: [], joints: [] });
const [MORNING, NOON] = ["2026-11-02T08:00:00+00:00", "2026-11-02T12:00:00+00:00"];

// Each layout has its own.
assert.equal(readDraft(1, MORNING), null);
storeDraft(1, { saved: MORNING, layout: layout("Vest") });
storeDraft(2, { saved: MORNING, layout: layout("Sleeve") });
assert.deepEqual(readDraft(1, MORNING), layout("Vest"));
assert.deepEqual(readDraft(2, MORNING), layout("Sleeve"));
forgetDraft(2);
assert.deepEqual(readDraft(1, MORNING), layout("Vest"));
assert.equal(readDraft(2, MORNING), null);

// Somebody saved it since, or it was deleted and its id is that of another one.
assert.equal(readDraft(1, NOON), null);

// What is no draft, and no storage at all.
for (const text of ["{", "null", '"x"', JSON.stringify({ saved: MORNING, layout: { channels: 1 } })]) {
  for (const key of kept.keys()) kept.set(key, text);
  assert.equal(readDraft(1, MORNING), null);
}
delete globalThis.sessionStorage;
storeDraft(1, { saved: MORNING, layout: layout("Vest") });
forgetDraft(1);
assert.equal(readDraft(1, MORNING), null);
console.log("the drafts of layouts hold");
