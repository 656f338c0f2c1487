/**
 * The plan on the workbench: kept on this screen, so that a reload or another page loses nothing.
 * @typedef {{document: any, name: string | null, version: number, dirty: boolean}} Draft
 * name: of the own plan that it is a version of; null for one that was never saved
 */

const PLACE = "bodydrive-plan-draft";

/** @type {Draft | null | undefined} undefined: not looked for yet */
let here;

/** @returns {Draft | null} */
export function keptDraft() {
  if (here !== undefined) return here;
  try {
    const read = JSON.parse(localStorage.getItem(PLACE) ?? "null");
    here = read && Array.isArray(read.document?.walls) && Array.isArray(read.document?.paths) ? read : null;
  } catch {
    here = null;
  }
  return here;
}

/** Keep a draft. @param {Draft | null} draft @returns {boolean} whether a reload would find it again */
export function keepDraft(draft) {
  here = draft;
  try {
    if (draft) localStorage.setItem(PLACE, JSON.stringify(draft));
    else localStorage.removeItem(PLACE);
    return true;
  } catch {
    // Larger than what a page may keep: it lives as long as this page does.
    localStorage.removeItem(PLACE);
    return false;
  }
}
