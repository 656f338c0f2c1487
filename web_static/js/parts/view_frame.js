/** The 3D view in its frame: when there is a picture, how fine it is drawn, and the guard against one that has stopped. */
import { t } from "../texts.js";
import { h, write } from "./dom.js";
import { number } from "./format.js";

const OLD = 1.0; // s: an older picture must not pass for the present
const DEAD = 3.0; // s: by then it will not come back by itself
const LOOK_EVERY = 250; // ms
const PATIENCE = 12000; // ms for a fresh frame to show its first picture, on a slow tablet; doubled in vain, up to ...
const LONGEST_PATIENCE = 96000; // ms: a machine that needs longer than it gets would load again for ever
const CALM = 4; // looks in a row without a stutter: loading is over, and Stop answers at once
const STUTTER = 450; // ms between two looks
const SLOW = 10; // pictures a second; a slower machine draws with fewer pixels, so that the view stays live
const QUICK = 45; // pictures a second; there is room for more pixels
const COARSE_PLACE = "bodydrive-view-coarse";
const PLOTS_WIDTH = 800; // px that the 3D view's page needs to lay its plots beside the picture
const COARSEST = 3; // screen pixels to one drawn pixel, each way

/**
 * `surface` lies over the picture, hidden until somebody wants to touch it.
 * `ready` comes true with the first live picture: nobody is to drive before there is something to see.
 * @param {AbortSignal} signal @param {"clinician" | "patient"} [role] whose picture it is
 * @returns {{element: HTMLElement, surface: HTMLElement, ready: Promise<void>, setPlots: (is: boolean) => void}}
 */
export function viewFrame(signal, role = "clinician") {
  const make = () => h("iframe", { src: `/view/${role}/`, title: t("trial.frame"), tabindex: "-1" });
  let frame = make();
  let loadedAt = performance.now();
  let lookedAt = loadedAt;
  let calm = 0;
  let patience = PATIENCE;
  const words = h("p", { class: "stale", role: "alert", hidden: true }, t("trial.stale"));
  const about = t("trial.view.surface");
  const surface = h("div", { class: "surface", tabindex: "0", role: "application", "aria-label": about, hidden: true });
  const paceWords = h("p", { class: "pace", "aria-live": "off" });
  const element = h("div", { class: "view" }, frame, surface, paceWords, words);
  const pace = frameCounter();
  let isReady = () => {};
  const ready = new Promise((resolve) => (isReady = () => resolve(undefined)));

  let mayRefine = true; // once: a machine on the border shall not go to and fro
  let hasPlots = false;
  let coarse = Number(sessionStorage.getItem(COARSE_PLACE)) || 1;
  const setCoarse = (times) => {
    coarse = times;
    sessionStorage.setItem(COARSE_PLACE, String(times));
    draw(element, times);
  };
  const suit = (rate) => {
    if (rate < SLOW) setCoarse(Math.min(COARSEST, coarse + 1));
    else if (rate > QUICK && coarse > 1 && mayRefine) {
      mayRefine = false;
      setCoarse(coarse - 1);
    }
  };
  draw(element, coarse);
  const look = () => {
    const now = performance.now();
    const age = pictureAge(frame);
    const isLive = age !== null && age < OLD;
    const isNew = now - loadedAt < patience;
    calm = isLive && now - lookedAt < STUTTER ? calm + 1 : 0;
    lookedAt = now;
    // A view that never comes must not keep the plan and the figures from being used.
    if (calm >= CALM || !isNew) isReady();
    const rate = isLive ? pace.perSecond(frame) : Infinity;
    if (Number.isFinite(rate)) {
      write(paceWords, paceSentence(rate, lag(frame), coarse));
      if (!hasPlots) suit(rate);
    }
    if (!isLive) write(paceWords, "");
    if (age === null || document.visibilityState !== "visible") return;
    words.hidden = isLive || isNew;
    if (age < DEAD || isNew) return;
    patience = age === Infinity ? Math.min(2 * patience, LONGEST_PATIENCE) : PATIENCE;
    loadedAt = now;
    const next = make();
    frame.replaceWith(next);
    frame = next;
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  /** Plots need room beside the picture, so that the frame may not become too narrow. @param {boolean} is */
  const setPlots = (is) => {
    hasPlots = is;
    draw(element, is ? Math.max(1, Math.min(coarse, element.clientWidth / PLOTS_WIDTH)) : coarse);
  };
  return { element, surface, ready, setPlots };
}

/** Seconds since the picture was last known to be live; null when the frame does not tell. */
function pictureAge(frame) {
  try {
    return frame.contentWindow?.bodydriveView?.age() ?? null;
  } catch {
    return null; // a frame that shows an error page belongs to nobody
  }
}

/** How old what is drawn is, s; null when the frame does not tell. */
function lag(frame) {
  try {
    return frame.contentWindow?.bodydriveView?.lag() ?? null;
  } catch {
    return null;
  }
}

/** @param {number} rate pictures a second @param {number | null} age s @param {number} coarse */
function paceSentence(rate, age, coarse) {
  const figures = t("trial.view.pace", { rate: number(rate, 0), age: age === null ? "–" : number(1000 * age, 0) });
  return rate < SLOW && coarse >= COARSEST ? `${figures}. ${t("trial.view.slow")}` : figures;
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

/** @param {HTMLElement} element @param {number} times screen pixels to one drawn pixel, each way */
function draw(element, times) {
  element.style.setProperty("--coarse", String(times));
}
