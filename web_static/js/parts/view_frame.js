/** The 3D view in its frame, and the guard against a picture that has stopped. */
import { t } from "../texts.js";
import { h } from "./dom.js";

const OLD = 1.0; // s: an older picture must not pass for the present
const DEAD = 3.0; // s: by then it will not come back by itself
const LOOK_EVERY = 250; // ms
const PATIENCE = 10000; // ms for a fresh frame to show its first picture, on a slow tablet

/**
 * `ready` comes true with the first live picture: nobody is to drive before there is something to see.
 * @param {AbortSignal} signal @returns {{element: HTMLElement, ready: Promise<void>}}
 */
export function viewFrame(signal) {
  const make = () => h("iframe", { src: "/view/clinician/", title: t("trial.frame"), tabindex: "-1" });
  let frame = make();
  let loadedAt = performance.now();
  const words = h("p", { class: "stale", role: "alert", hidden: true }, t("trial.stale"));
  const element = h("div", { class: "view" }, frame, words);
  let isReady = () => {};
  const ready = new Promise((resolve) => (isReady = () => resolve(undefined)));
  const look = () => {
    const age = pictureAge(frame);
    const isNew = performance.now() - loadedAt < PATIENCE;
    if (age !== null && age < OLD) isReady();
    else if (!isNew) isReady(); // a view that never comes must not keep the plan and the figures from being used
    if (age === null || document.visibilityState !== "visible") return;
    words.hidden = age < OLD || isNew;
    if (age < DEAD || isNew) return;
    loadedAt = performance.now();
    const next = make();
    frame.replaceWith(next);
    frame = next;
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  return { element, ready };
}

/** Seconds since the picture was last known to be live; null when the frame does not tell. */
function pictureAge(frame) {
  try {
    return frame.contentWindow?.bodydriveView?.age() ?? null;
  } catch {
    return null; // a frame that shows an error page belongs to nobody
  }
}
