/**
 * The layouts that are being changed, kept in this tab so that a reload loses nothing.
 * @import { ShirtLayout } from "types/api"
 * @typedef {{saved: string, layout: ShirtLayout}} Draft saved: when the layout was saved that was changed
 */

const STORAGE_KEY = "bodydrive-layout-draft-"; // and the id of the layout

/**
 * The changes of a layout that were not saved; null when there are none, or somebody saved it since. The id of a layout
 * that was deleted may be that of another one, but both were not saved at the same moment.
 * @param {number} id @param {string} saved @returns {ShirtLayout | null}
 */
export function readDraft(id, saved) {
  try {
    /** @type {Draft | null} */
    const draft = JSON.parse(sessionStorage.getItem(STORAGE_KEY + id) ?? "null");
    return draft?.saved === saved && Array.isArray(draft.layout?.channels) ? draft.layout : null;
  } catch {
    return null;
  }
}

/** @param {number} id @param {Draft} draft */
export function storeDraft(id, draft) {
  try {
    sessionStorage.setItem(STORAGE_KEY + id, JSON.stringify(draft));
  } catch {
    // Without storage the changes last as long as the page.
  }
}

/** @param {number} id */
export function forgetDraft(id) {
  try {
    sessionStorage.removeItem(STORAGE_KEY + id);
  } catch {
    // There is nothing to forget.
  }
}
