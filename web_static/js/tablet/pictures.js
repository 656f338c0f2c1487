/** Pictures of the steps: a screen of the device, drawn in outline, with the rows to tap marked. */
import { s } from "../widgets/dom.js";

const WIDTH = 240;
const ROW = 34;
const TOP = 40;

/**
 * One row of a drawn screen; `mark` is the one to tap.
 * @typedef {{text: string, mark?: boolean, toggle?: boolean}} Row
 */

/** Draw a screen with a title and rows. @param {string} title @param {Row[]} rows */
export function screenPicture(title, rows) {
  const height = TOP + rows.length * ROW + 14;
  const marked = rows.filter((row) => row.mark);
  const words = [title, ...rows.map((row) => (row.mark ? `→ ${row.text}` : row.text))].join(", ");
  return s(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${height}`, role: "img", "aria-label": words },
    s("rect", {
      x: 1,
      y: 1,
      width: WIDTH - 2,
      height: height - 2,
      rx: 12,
      fill: "var(--surface)",
      stroke: "var(--control-edge)",
      "stroke-width": 2,
    }),
    s(
      "text",
      { x: WIDTH / 2, y: 25, "text-anchor": "middle", "font-size": 13, "font-weight": 650, fill: "var(--text)" },
      title,
    ),
    ...rows.map((row, index) => drawnRow(row, row.mark ? marked.indexOf(row) + 1 : 0, TOP + index * ROW)),
  );
}

/** @param {Row} row @param {number} turn  0: not to be tapped @param {number} y */
function drawnRow(row, turn, y) {
  const middle = y + ROW / 2;
  return s(
    "g",
    {},
    s("rect", {
      x: 12,
      y: y + 2,
      width: WIDTH - 24,
      height: ROW - 4,
      rx: 6,
      fill: row.mark ? "var(--action-wash)" : "var(--panel)",
      stroke: row.mark ? "var(--action)" : "var(--border)",
      "stroke-width": row.mark ? 3 : 1,
    }),
    s("text", { x: 22, y: middle + 4, "font-size": 12, fill: "var(--text)" }, row.text),
    row.toggle ? toggle(middle) : turn > 0 && place(turn, middle),
  );
}

/** A switch that is on. @param {number} y */
function toggle(y) {
  return [
    s("rect", { x: WIDTH - 58, y: y - 10, width: 36, height: 20, rx: 10, fill: "var(--good)" }),
    s("circle", { cx: WIDTH - 32, cy: y, r: 8, fill: "var(--panel)" }),
  ];
}

/** The place to tap, with its turn: 1, 2 ... @param {number} turn @param {number} y */
function place(turn, y) {
  return [
    s("circle", { cx: WIDTH - 32, cy: y, r: 11, fill: "var(--action)" }),
    s(
      "text",
      {
        x: WIDTH - 32,
        y: y + 4,
        "text-anchor": "middle",
        "font-size": 12,
        "font-weight": 650,
        fill: "var(--action-text)",
      },
      turn,
    ),
  ];
}

/** The sign of the check: a tick, a clock, or dots while nothing is known. @param {"trusted" | "clock" | "waiting"} state */
export function signPicture(state) {
  const colour = { trusted: "var(--good)", clock: "var(--attention)", waiting: "var(--text-quiet)" }[state];
  const inside = {
    trusted: "M16 29l9 9 16 -19",
    clock: "M28 16v13l9 6",
    waiting: "M17 28h.1M28 28h.1M39 28h.1",
  }[state];
  return s(
    "svg",
    { viewBox: "0 0 56 56", "aria-hidden": "true" },
    s("circle", {
      cx: 28,
      cy: 28,
      r: 24,
      fill: state === "trusted" ? colour : "none",
      stroke: colour,
      "stroke-width": 4,
    }),
    s("path", {
      d: inside,
      fill: "none",
      stroke: state === "trusted" ? "var(--good-wash)" : colour,
      "stroke-width": 5,
      "stroke-linecap": "round",
      "stroke-linejoin": "round",
    }),
  );
}
