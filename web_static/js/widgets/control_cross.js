/** u1 and u2 as a point in a square: up is faster, left is left. */
import { t } from "../texts.js";
import { s, set } from "./dom.js";

const HALF = 100;

/** @param {{hasWords?: boolean}} [options] */
export function cross({ hasWords = true } = {}) {
  const dot = s("circle", { class: "dot", r: 13 });
  /** @param {number} x @param {number} y @param {string} key */
  const word = (x, y, key) => s("text", { x, y, "text-anchor": "middle" }, t(key));
  const element = s(
    "svg",
    { class: "cross", viewBox: "-106 -106 212 212", role: "img", "aria-label": t("cross-label") },
    s("rect", { x: -HALF, y: -HALF, width: 2 * HALF, height: 2 * HALF, rx: 12 }),
    s("line", { x1: -HALF, x2: HALF }),
    s("line", { y1: -HALF, y2: HALF }),
    hasWords && [
      word(0, -82, "cross-faster"),
      word(0, 93, "cross-slower"),
      word(-74, -8, "cross-left"),
      word(72, -8, "cross-right"),
    ],
    dot,
  );
  /** @param {number} u1 @param {number} u2 */
  const show = (u1, u2) => set(dot, { cx: -u2 * (HALF - 14), cy: -u1 * (HALF - 14) });
  return { element, show };
}
