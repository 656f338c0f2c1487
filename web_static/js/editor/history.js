/**
 * Undo and redo: the versions of a document, none of them changed in place.
 * @template T @typedef {{past: T[], now: T, future: T[]}} History
 */

const MOST = 200; // steps that can be taken back

/** @template T @param {T} now @returns {History<T>} */
export function newHistory(now) {
  return { past: [], now, future: [] };
}

/**
 * Add a version; an unchanged one is not added. @template T
 * @param {History<T>} history @param {T} next @returns {History<T>}
 */
export function addStep(history, next) {
  if (next === history.now) return history;
  return { past: [...history.past, history.now].slice(-MOST), now: next, future: [] };
}

/** @template T @param {History<T>} history @returns {History<T>} */
export function stepBack(history) {
  if (!history.past.length) return history;
  return {
    past: history.past.slice(0, -1),
    now: history.past[history.past.length - 1],
    future: [history.now, ...history.future],
  };
}

/** @template T @param {History<T>} history @returns {History<T>} */
export function stepForward(history) {
  if (!history.future.length) return history;
  return { past: [...history.past, history.now], now: history.future[0], future: history.future.slice(1) };
}
