/** The 3D view in its frame, and the guard against a picture that has stopped. */
import { t } from "../texts.js";
import { h } from "./dom.js";

const OLD = 1.0; // s: an older picture must not pass for the present
const LOOK_EVERY = 250; // ms
const PATIENCE = 6000; // ms for a fresh frame to show its first picture, on a slow tablet

/** @param {AbortSignal} signal */
export function viewFrame(signal) {
  const make = () => h("iframe", { src: "/view/clinician/", title: t("trial.frame"), tabindex: "-1" });
  let frame = make();
  let loadedAt = performance.now();
  const words = h("p", { class: "stale", role: "alert", hidden: true }, t("trial.stale"));
  const element = h("div", { class: "view" }, frame, words);
  const look = () => {
    const age = pictureAge(frame);
    if (age === null || document.visibilityState !== "visible") return;
    const isStale = age > OLD;
    const isNew = performance.now() - loadedAt < PATIENCE;
    words.hidden = !isStale || isNew;
    if (!isStale || isNew) return;
    loadedAt = performance.now();
    const next = make();
    frame.replaceWith(next);
    frame = next;
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  return element;
}

/** Seconds since the picture was last known to be live; null when the frame does not tell. */
function pictureAge(frame) {
  try {
    return frame.contentWindow?.bodydriveView?.age() ?? null;
  } catch {
    return null; // a frame that shows an error page belongs to nobody
  }
}
