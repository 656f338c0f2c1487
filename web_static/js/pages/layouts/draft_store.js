/**
 * The layout that is being changed, kept in this tab so that a reload loses nothing.
 * @import { ShirtLayout } from "types/api"
 * @typedef {{id: number, version: number, layout: ShirtLayout}} Draft version: that was changed
 */

const STORAGE_KEY = "bodydrive-layout-draft";

/** The changes of a layout that were not saved; null when there are none, or somebody saved it since. @param {number} id @param {number} version @returns {ShirtLayout | null} */
export function readDraft(id, version) {
  try {
    /** @type {Draft | null} */
    const draft = JSON.parse(sessionStorage.getItem(STORAGE_KEY) ?? "null");
    return draft?.id === id && draft.version === version && Array.isArray(draft.layout?.channels) ? draft.layout : null;
  } catch {
    return null;
  }
}

/** @param {Draft} draft */
export function storeDraft(draft) {
  try {
    sessionStorage.setItem(STORAGE_KEY, JSON.stringify(draft));
  } catch {
    // Without storage the changes last as long as the page.
  }
}

export function forgetDraft() {
  try {
    sessionStorage.removeItem(STORAGE_KEY);
  } catch {
    // There is nothing to forget.
  }
}
