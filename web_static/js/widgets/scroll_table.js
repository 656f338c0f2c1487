/**
 * A table in a region of its own that scrolls sideways: a narrow screen keeps all of its columns.
 * @import { ComponentChildren } from "../../vendor/preact/preact.js"
 */
import { h } from "../preact.js";

/**
 * @param {object} table
 * @param {string} table.label what the region is called @param {string} table.kind classes of the table
 * @param {ComponentChildren} [table.children] head and body
 */
export function ScrollTable({ label, kind, children }) {
  return h(
    "div",
    { class: "scroll-x", tabindex: 0, role: "region", "aria-label": label },
    h("table", { class: kind }, children),
  );
}

/**
 * The head of a table, a cell for each of its columns.
 * @param {{columns: string[], children?: ComponentChildren}} head children: further cells
 */
export function TableHead({ columns, children }) {
  return h(
    "thead",
    {},
    h(
      "tr",
      {},
      columns.map((words) => h("th", { key: words, scope: "col" }, words)),
      children,
    ),
  );
}
