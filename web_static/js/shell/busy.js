/** What is going on while nothing of a page can be changed: a line that stays in its foot, with the way to it. */
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";

/** The page of each; a trial is recorded too, so it comes before a step of the calibration. */
const PLACES = /** @type {const} */ ({
  trial: "#/drive",
  drive: "#/drive/chair",
  test: "#/interface_test",
  run: "#/calibrate",
});
const KINDS = /** @type {(keyof typeof PLACES)[]} */ (Object.keys(PLACES));

/**
 * Follow the live picture until `signal`; `follow` is called when something begins or ends.
 * @param {import("../main.js").App} app @param {AbortSignal} signal @param {(isBusy: boolean) => void} follow
 */
export function busyLine(app, signal, follow) {
  const element = h("p", { class: "foot-line busy", role: "status" });
  /** @type {keyof typeof PLACES | undefined} */
  let shown;
  const show = () => {
    const now = KINDS.find((kind) => app.live.latest?.[kind]);
    if (now === shown) return;
    shown = now;
    put(
      element,
      now && [
        h("span", { class: "grow" }, t(`busy-${now}`)),
        h("a", { class: "btn", href: PLACES[now] }, t(`busy-${now}-go`)),
      ],
    );
    follow(now !== undefined);
  };
  app.live.addEventListener("tick", show, { signal });
  show();
  return element;
}
