/**
 * A table in a region of its own that scrolls sideways: a narrow screen keeps all of its columns.
 * @import { ComponentChildren } from "../../vendor/preact/preact.js"
 */
import { h as draw } from "../preact.js";
import { h } from "./dom.js";

/**
 * @param {string} label what the region is called @param {string} kind classes of the table
 * @param {...import("types/dom").Child} parts head and body of the table
 */
export function scrollTable(label, kind, ...parts) {
  return h(
    "div",
    { class: "scroll-x", tabindex: "0", role: "region", "aria-label": label },
    h("table", { class: kind }, parts),
  );
}

/** The same as a component. @param {{label: string, kind: string, children?: ComponentChildren}} table */
export function ScrollTable({ label, kind, children }) {
  return draw(
    "div",
    { class: "scroll-x", tabindex: 0, role: "region", "aria-label": label },
    draw("table", { class: kind }, children),
  );
}

/**
 * The head of a table, a cell for each of its columns.
 * @param {{columns: string[], children?: ComponentChildren}} head children: further cells
 */
export function TableHead({ columns, children }) {
  return draw(
    "thead",
    {},
    draw(
      "tr",
      {},
      columns.map((words) => draw("th", { key: words, scope: "col" }, words)),
      children,
    ),
  );
}
