/**
 * The button that clears a latched stop or fault: Continue in a trial or drive, and taking the stop back when nothing runs.
 * @import { App } from "../main.js"
 */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";

const TAPS_AFTER = 1000; // ms: a tap that comes sooner was meant for what stood there before

/** A reviewer looks, and stops; others go on. @param {App} app */
export const mayGoOn = (app) => app.me?.role !== "reviewer";

/**
 * It clears the stops that had come when it could first be pressed, and none that came later. In its first second, and in
 * the first after `setBlocked(false)`, it takes no tap and looks so.
 * @param {App} app @param {string} [words]
 * @returns {{element: HTMLButtonElement, setBlocked: (is: boolean) => void, seen: () => number | null}} `seen`: the count of
 * stops that the person has had time to see; null before
 */
export function continueButton(app, words = t("note-fault-continue")) {
  let [stops, timer, isBlocked] = [0, 0, false];
  /** @type {number | null} */
  let seen = null;
  setTimeout(() => (seen = app.live.latest?.stops ?? null), TAPS_AFTER);
  /** @param {boolean} off */
  const setOff = (off) => element.setAttribute("aria-disabled", String(off));
  const element = h("button", { type: "button", class: "btn go continue", hidden: !mayGoOn(app) }, words);
  /** @param {boolean} is */
  const setBlocked = (is) => {
    isBlocked = is;
    clearTimeout(timer);
    setOff(true);
    if (is) return;
    timer = setTimeout(() => {
      stops = app.live.latest?.stops ?? 0;
      setOff(false);
    }, TAPS_AFTER);
  };
  element.addEventListener("click", async () => {
    if (element.getAttribute("aria-disabled") === "true") return;
    setOff(true);
    await app.toasts.attempt(() => app.api.post("/control/clear", { stops }));
    setBlocked(isBlocked);
  });
  setBlocked(false);
  return { element, setBlocked, seen: () => seen };
}
