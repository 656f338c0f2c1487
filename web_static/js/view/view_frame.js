/** The 3D view in its frame: whether it has a live picture, why not, and how fine it is drawn. */
import { t } from "../texts.js";
import { h, write } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { frameCounter } from "./frame_rate.js";
import { LOOK_EVERY, ageLimit } from "./picture_age.js";
import { canDrawIn3d } from "./webgl.js";

const DEAD = 3.0; // s: by then a picture will not come back by itself
const PATIENCE = 12000; // ms for a fresh frame to show its first picture, on a slow tablet; doubled in vain, up to ...
const LONGEST_PATIENCE = 96000; // ms: a machine that needs longer than it gets would load again for ever
const CALM = 4; // looks in a row without a stutter: loading is over, and Stop answers at once
const SLOW = 10; // pictures a second; a slower machine draws with fewer pixels, so that the view stays live
const QUICK = 45; // pictures a second; there is room for more pixels
const COARSE_PLACE = "bodydrive-view-coarse";
const PLOTS_WIDTH = 800; // px that the 3D view's page needs to lay its plots beside the picture
const COARSEST = 3; // screen pixels to one drawn pixel, each way

/** @typedef {"" | "coming" | "late" | "webgl" | "context" | "stale"} Why why there is no live picture; empty: there is one */

/**
 * `surface` lies over the picture, hidden until somebody wants to touch it.
 * @param {AbortSignal} signal @param {"clinician" | "patient"} [role] whose picture it is
 * @param {() => void} [onChange] `why` has changed
 * @returns {{element: HTMLElement, surface: HTMLElement, why: () => Why, setWanted: (is: boolean) => void, setPlots: (is: boolean) => void}}
 *   a view that is not wanted costs nothing: its frame is gone, until it is wanted again
 */
export function viewFrame(signal, role = "clinician", onChange = () => {}) {
  const make = () => h("iframe", { src: `/view/${role}/`, title: t("trial.frame"), tabindex: "-1" });
  const words = h("p", { class: "stale", role: "alert", hidden: true });
  const about = t("trial.view.surface");
  const surface = h("div", { class: "surface", tabindex: "0", role: "application", "aria-label": about, hidden: true });
  const paceWords = h("p", { class: "pace", "aria-live": "off" });
  const element = h("div", { class: "view" }, surface, paceWords, words);
  /** @type {Why} */
  let why = "coming";
  const tell = (now) => {
    if (now === why) return;
    why = now;
    words.hidden = why === "" || why === "coming";
    write(words, words.hidden ? "" : t(`picture.${why}`));
    element.classList.toggle("without", why === "webgl" || why === "context");
    onChange();
  };
  const shown = { element, surface, why: () => why, setWanted: (_is) => {}, setPlots: (_is) => {} };
  if (!canDrawIn3d()) {
    tell("webgl");
    return shown;
  }

  let frame = make();
  let isWanted = true;
  element.prepend(frame);
  let loadedAt = performance.now();
  let deadSince = Infinity; // ms of performance.now, since when the browser has taken the drawing context away
  let calm = 0;
  let isBegun = false; // this frame has shown a live picture
  let patience = PATIENCE;
  const pace = frameCounter();
  const age = ageLimit();

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
  const showPace = (isLive) => {
    const rate = isLive ? pace.perSecond(frame) : Infinity;
    if (!isLive) write(paceWords, "");
    if (!Number.isFinite(rate)) return;
    write(paceWords, paceSentence(rate, ask(frame, "lag", null), coarse));
    if (!hasPlots) suit(rate);
  };
  const look = () => {
    const { onTime, limit } = age();
    if (!isWanted || document.visibilityState !== "visible") return;
    const now = performance.now();
    const isDrawn = ask(frame, "draws", true);
    const old = ask(frame, "age", Infinity);
    const isLive = isDrawn && old < limit;
    const isNew = now - loadedAt < patience;
    calm = isLive && onTime ? calm + 1 : 0;
    deadSince = isDrawn ? Infinity : Math.min(deadSince, now);
    showPace(isLive);
    if (!isDrawn) tell("context");
    else if (isLive && (isBegun || calm >= CALM || !isNew)) {
      isBegun = true;
      tell("");
    } else if (!isLive && isBegun) tell("stale");
    else if (!isNew && why === "coming") tell("late");
    const isDead = now - deadSince > 1000 * DEAD || (isDrawn && old >= DEAD && !isNew);
    if (isDead) renew(now, old);
  };
  const renew = (now, old) => {
    patience = old === Infinity ? Math.min(2 * patience, LONGEST_PATIENCE) : PATIENCE;
    if (canDrawIn3d()) return load();
    [loadedAt, deadSince] = [now, Infinity]; // look again later: a browser may give the context back
    tell("webgl");
  };
  const load = () => {
    [loadedAt, deadSince, isBegun, calm] = [performance.now(), Infinity, false, 0];
    frame.remove();
    frame = make();
    element.prepend(frame);
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  shown.setWanted = (is) => {
    if (is === isWanted) return;
    isWanted = is;
    write(paceWords, "");
    if (is) load();
    else frame.remove();
    tell("coming");
  };
  /** Plots need room beside the picture, so that the frame may not become too narrow. @param {boolean} is */
  shown.setPlots = (is) => {
    hasPlots = is;
    draw(element, is ? Math.max(1, Math.min(coarse, element.clientWidth / PLOTS_WIDTH)) : coarse);
  };
  return shown;
}

/**
 * Return what the page in the frame tells of its picture; `otherwise` while it tells nothing.
 * @template T @param {HTMLIFrameElement} frame @param {"age" | "lag" | "draws"} what @param {T} otherwise
 */
function ask(frame, what, otherwise) {
  try {
    return frame.contentWindow?.bodydriveView?.[what]() ?? otherwise;
  } catch {
    return otherwise; // a frame with an error page cannot be read
  }
}

/** @param {number} rate pictures a second @param {number | null} age s @param {number} coarse */
function paceSentence(rate, age, coarse) {
  const figures = t("trial.view.pace", { rate: number(rate, 0), age: age === null ? "–" : number(1000 * age, 0) });
  return rate < SLOW && coarse >= COARSEST ? `${figures}. ${t("trial.view.slow")}` : figures;
}

/** @param {HTMLElement} element @param {number} times screen pixels to one drawn pixel, each way */
function draw(element, times) {
  element.style.setProperty("--coarse", String(times));
}
