/**
 * What is going on while nothing of a page can be changed: a line that stays in its foot, with the way to it.
 * @import { LiveMessage } from "../live/live.js"
 */
import { h } from "../preact.js";
import { t } from "../texts.js";

/** The page of each; a trial is recorded too, so it comes before a step of the calibration. */
const PLACES = /** @type {const} */ ({
  trial: "#/drive",
  drive: "#/drive/chair",
  test: "#/interface_test",
  run: "#/calibrate",
});
const KINDS = /** @type {(keyof typeof PLACES)[]} */ (Object.keys(PLACES));

/** What is going on; undefined: nothing. @param {LiveMessage | null} now */
export const busyKind = (now) => KINDS.find((kind) => now?.[kind]);

/** @param {{kind: ReturnType<typeof busyKind>}} line */
export function BusyLine({ kind }) {
  return h(
    "p",
    { class: "foot-line busy", role: "status" },
    kind && h("span", { class: "grow" }, t(`busy-${kind}`)),
    kind && h("a", { class: "btn", href: PLACES[kind] }, t(`busy-${kind}-go`)),
  );
}
