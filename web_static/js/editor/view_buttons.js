/** Buttons that zoom and pan the drawing, and show all of it: for people without touch or wheel. */
import { h } from "../preact.js";
import { t } from "../texts.js";
import { panView, zoomView } from "./viewport.js";

export const ZOOM = 1.4; // of one tap on + or −
const PAN = 90; // px of one tap on an arrow

/**
 * @typedef {import("./viewport.js").View} View
 * @typedef {(view: View, size: import("./viewport.js").Size) => View} ViewChange
 */

/** @param {{look: (change: ViewChange) => void, showAll: () => void}} buttons */
export function ViewButtons({ look, showAll }) {
  /** @param {string} name @param {string} words @param {() => void} onClick */
  const button = (name, words, onClick) =>
    h("button", { type: "button", class: "btn small", "aria-label": t(`editor-${name}`), onClick }, words);
  /** @param {number} dx px @param {number} dy px */
  const pan = (dx, dy) => () => look((view) => panView(view, dx, dy));
  /** @param {number} factor */
  const zoom = (factor) => () => look((view, size) => zoomView(view, size, factor));
  return h(
    "div",
    { class: "views", role: "group", "aria-label": t("editor-views") },
    button("nearer", "+", zoom(ZOOM)),
    button("farther", "−", zoom(1 / ZOOM)),
    button("left", "←", pan(PAN, 0)),
    button("right", "→", pan(-PAN, 0)),
    button("up", "↑", pan(0, PAN)),
    button("down", "↓", pan(0, -PAN)),
    button("all", t("editor-all-short"), showAll),
  );
}
