/**
 * The plan on the workbench: stored in this browser, so that a reload or another page loses nothing.
 * @typedef {{document: import("./document.js").Plan, name: string | null, version: number, dirty: boolean}} Draft
 * name: of the own plan that it is a version of; null for one that was never saved
 */

const STORAGE_KEY = "bodydrive-plan-draft";

/** @type {Draft | null | undefined} undefined: not read yet */
let current;

/** The stored draft; null when there is none. @returns {Draft | null} */
export function readDraft() {
  if (current !== undefined) return current;
  current = storedDraft();
  return current;
}

/** @returns {Draft | null} */
function storedDraft() {
  try {
    const draft = JSON.parse(localStorage.getItem(STORAGE_KEY) ?? "null");
    return draft && Array.isArray(draft.document?.walls) && Array.isArray(draft.document?.paths) ? draft : null;
  } catch {
    return null;
  }
}

/** Store a draft. @param {Draft | null} draft @returns {boolean} whether a reload would find it again */
export function storeDraft(draft) {
  current = draft;
  try {
    if (draft) localStorage.setItem(STORAGE_KEY, JSON.stringify(draft));
    else localStorage.removeItem(STORAGE_KEY);
    return true;
  } catch {
    // The draft is larger than the browser's storage: it lasts only as long as this page.
    localStorage.removeItem(STORAGE_KEY);
    return false;
  }
}
