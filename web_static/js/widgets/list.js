/** A list of rows: it is called a list only while it has rows, because a list without any is an error to screen readers. */
import { h, put, set } from "./dom.js";

/** @typedef {HTMLElement & {show: (rows: HTMLElement[], words?: HTMLElement | null) => void}} RowList */

/**
 * `show` replaces its rows; without rows it shows the words instead.
 * @param {string} kind its class
 * @returns {RowList}
 */
export function rowList(kind) {
  const element = h("div", { class: kind });
  /** @param {HTMLElement[]} rows @param {HTMLElement | null} [words] */
  const show = (rows, words = null) => {
    for (const row of rows) set(row, { role: "listitem" });
    set(element, { role: rows.length ? "list" : null });
    put(element, rows.length ? rows : words);
  };
  return Object.assign(element, { show });
}
