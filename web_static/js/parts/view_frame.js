/** The 3D view in its frame: when there is a picture, how fine it is drawn, and the guard against one that has stopped. */
import { t } from "../texts.js";
import { h } from "./dom.js";

const OLD = 1.0; // s: an older picture must not pass for the present
const DEAD = 3.0; // s: by then it will not come back by itself
const LOOK_EVERY = 250; // ms
const PATIENCE = 12000; // ms for a fresh frame to show its first picture, on a slow tablet
const CALM = 4; // looks in a row without a stutter: loading is over, and Stop answers at once
const STUTTER = 450; // ms between two looks
const SLOW = 10; // pictures a second; a slower machine draws with fewer pixels, so that the view stays live
const COARSE_PLACE = "bodydrive-view-coarse";
const COARSEST = 3; // screen pixels to one drawn pixel, each way

/**
 * `ready` comes true with the first live picture: nobody is to drive before there is something to see.
 * @param {AbortSignal} signal @returns {{element: HTMLElement, ready: Promise<void>}}
 */
export function viewFrame(signal) {
  const make = () => h("iframe", { src: "/view/clinician/", title: t("trial.frame"), tabindex: "-1" });
  let frame = make();
  let loadedAt = performance.now();
  let lookedAt = loadedAt;
  let calm = 0;
  const words = h("p", { class: "stale", role: "alert", hidden: true }, t("trial.stale"));
  const element = h("div", { class: "view" }, frame, words);
  const pace = frameCounter();
  setCoarse(element, Number(sessionStorage.getItem(COARSE_PLACE)) || 1);
  let isReady = () => {};
  const ready = new Promise((resolve) => (isReady = () => resolve(undefined)));

  const look = () => {
    const now = performance.now();
    const age = pictureAge(frame);
    const isLive = age !== null && age < OLD;
    const isNew = now - loadedAt < PATIENCE;
    calm = isLive && now - lookedAt < STUTTER ? calm + 1 : 0;
    lookedAt = now;
    // A view that never comes must not keep the plan and the figures from being used.
    if (calm >= CALM || !isNew) isReady();
    if (isLive && pace.perSecond(frame) < SLOW) setCoarse(element, Math.min(COARSEST, coarseness(element) + 1));
    if (age === null || document.visibilityState !== "visible") return;
    words.hidden = isLive || isNew;
    if (age < DEAD || isNew) return;
    loadedAt = now;
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

/** Counts the pictures of a frame over two seconds; Infinity while it does not know yet. */
function frameCounter() {
  const WINDOW = 2000; // ms
  let counted = null;
  let pictures = 0;
  let since = 0;
  return {
    perSecond(frame) {
      const view = frame.contentWindow;
      if (counted !== view) {
        counted = view;
        const count = () => {
          pictures += 1;
          if (counted === view) view.requestAnimationFrame(count);
        };
        [pictures, since] = [0, performance.now()];
        count();
      }
      const time = performance.now() - since;
      if (time < WINDOW || document.visibilityState !== "visible") return Infinity;
      const rate = (1000 * pictures) / time;
      [pictures, since] = [0, performance.now()];
      return rate;
    },
  };
}

function coarseness(element) {
  return Number(element.style.getPropertyValue("--coarse")) || 1;
}

function setCoarse(element, times) {
  element.style.setProperty("--coarse", String(times));
  sessionStorage.setItem(COARSE_PLACE, String(times));
}
