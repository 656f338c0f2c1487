/** Nearer, farther, to the sides, and everything at once: what fingers and wheel do, by buttons. */
import { h } from "../widgets/dom.js";
import { t } from "../texts.js";
import { panned, zoomed } from "./viewport.js";

export const ZOOM = 1.4; // of one tap on + or −
const PAN = 90; // px of one tap on an arrow

/**
 * @param {(change: (view: import("./viewport.js").View, size: import("./viewport.js").Size) => import("./viewport.js").View) => void} look
 * @param {() => void} lookAtAll
 */
export function viewButtons(look, lookAtAll) {
  const button = (name, words, onclick) =>
    h("button", { type: "button", class: "btn small", "aria-label": t(`editor.${name}`), onclick }, words);
  const pan = (dx, dy) => () => look((view) => panned(view, dx, dy));
  const zoom = (factor) => () => look((view, size) => zoomed(view, size, factor));
  return h(
    "div",
    { class: "views", role: "group", "aria-label": t("editor.views") },
    button("nearer", "+", zoom(ZOOM)),
    button("farther", "−", zoom(1 / ZOOM)),
    button("left", "←", pan(PAN, 0)),
    button("right", "→", pan(-PAN, 0)),
    button("up", "↑", pan(0, PAN)),
    button("down", "↓", pan(0, -PAN)),
    button("all", t("editor.all.short"), lookAtAll),
  );
}
