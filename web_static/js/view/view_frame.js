/** The 3D view in its frame: whether its picture is live, why not, and how finely it is drawn. */
import { t } from "../texts.js";
import { h, write } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { frameCounter } from "./frame_rate.js";
import { LOOK_EVERY, ageLimit } from "./picture_age.js";
import { canDrawIn3d } from "./webgl.js";

const DEAD = 3.0; // s: by then a picture will not come back by itself
const PATIENCE = 12000; // ms for a new frame to show its first picture, on a slow tablet; doubled after each failure, up to ...
const LONGEST_PATIENCE = 96000; // ms; a fixed patience would reload a slow machine for ever
const CALM = 4; // looks in a row that are on time: loading is over, and Stop reacts at once
const SLOW = 10; // pictures a second; a slower machine draws fewer pixels, so that the view stays live
const QUICK = 45; // pictures a second; a faster machine can draw more pixels
const STORAGE_KEY = "bodydrive-view-coarse";
const PLOTS_WIDTH = 800; // px that the 3D view's page needs to lay its plots beside the picture
const COARSEST = 3; // screen pixels to one drawn pixel, each way

/**
 * @typedef {"" | "coming" | "late" | "webgl" | "context" | "stale"} Why why there is no live picture; empty: there is one
 * @typedef {object} ViewFrame
 * @property {HTMLElement} element
 * @property {HTMLElement} surface lies over the picture, hidden until somebody wants to touch it
 * @property {() => Why} why
 * @property {(is: boolean) => void} setWanted a view that is not wanted has no frame and costs nothing
 * @property {(is: boolean) => void} setPlots plots need a picture that is wide enough
 */

/**
 * @param {AbortSignal} signal @param {"clinician" | "patient"} [role] whose picture it is
 * @param {() => void} [onChange] `why` has changed
 * @returns {ViewFrame}
 */
export function viewFrame(signal, role = "clinician", onChange = () => {}) {
  const make = () => h("iframe", { src: `/view/${role}/`, title: t("trial-frame"), tabindex: "-1" });
  const words = h("p", { class: "stale", role: "alert", hidden: true });
  const about = t("trial-view-surface");
  const surface = h("div", { class: "surface", tabindex: "0", role: "application", "aria-label": about, hidden: true });
  const paceWords = h("p", { class: "pace", "aria-live": "off" });
  const element = h("div", { class: "view" }, surface, paceWords, words);
  /** @type {Why} */
  let why = "coming";
  /** @param {Why} next */
  const tell = (next) => {
    if (next === why) return;
    why = next;
    words.hidden = why === "" || why === "coming";
    write(words, words.hidden ? "" : t(`picture-${why}`));
    element.classList.toggle("without", why === "webgl" || why === "context");
    onChange();
  };
  if (!canDrawIn3d()) {
    tell("webgl");
    return { element, surface, why: () => why, setWanted: () => {}, setPlots: () => {} };
  }

  let frame = make();
  let isWanted = true;
  element.prepend(frame);
  let loadedAt = performance.now();
  let deadSince = Infinity; // ms of performance.now when the browser took the drawing context away
  let calm = 0;
  let wasLive = false; // this frame has shown a live picture
  let patience = PATIENCE;
  const pace = frameCounter();
  const age = ageLimit();

  let mayRefine = true; // once, so that a machine at the limit does not change to and fro
  let hasPlots = false;
  let coarse = Number(sessionStorage.getItem(STORAGE_KEY)) || 1;
  /** @param {number} times screen pixels to one drawn pixel, each way */
  const setCoarse = (times) => {
    coarse = times;
    sessionStorage.setItem(STORAGE_KEY, String(times));
    draw(element, times);
  };
  /** Draw coarser when the view is slow, finer when it is quick. @param {number} rate pictures a second */
  const adjust = (rate) => {
    if (rate < SLOW) setCoarse(Math.min(COARSEST, coarse + 1));
    else if (rate > QUICK && coarse > 1 && mayRefine) {
      mayRefine = false;
      setCoarse(coarse - 1);
    }
  };
  draw(element, coarse);
  /** @param {boolean} isLive */
  const showPace = (isLive) => {
    const rate = isLive ? pace.perSecond(frame) : Infinity;
    if (!isLive) write(paceWords, "");
    if (!Number.isFinite(rate)) return;
    write(paceWords, paceSentence(rate, pictureOf(frame)?.lag() ?? null, coarse));
    if (!hasPlots) adjust(rate);
  };
  const look = () => {
    const { onTime, limit } = age();
    if (!isWanted || document.visibilityState !== "visible") return;
    const now = performance.now();
    const picture = pictureOf(frame);
    const isDrawn = picture?.draws() ?? true;
    const old = picture?.age() ?? Infinity;
    const isLive = isDrawn && old < limit;
    const isNew = now - loadedAt < patience;
    calm = isLive && onTime ? calm + 1 : 0;
    deadSince = isDrawn ? Infinity : Math.min(deadSince, now);
    showPace(isLive);
    if (!isDrawn) tell("context");
    else if (isLive && (wasLive || calm >= CALM || !isNew)) {
      wasLive = true;
      tell("");
    } else if (!isLive && wasLive) tell("stale");
    else if (!isNew && why === "coming") tell("late");
    const isDead = now - deadSince > 1000 * DEAD || (isDrawn && old >= DEAD && !isNew);
    if (isDead) renew(now, old);
  };
  /**
   * Load the frame anew, if the browser can draw.
   * @param {number} now ms of performance.now @param {number} old s, age of the picture
   */
  const renew = (now, old) => {
    patience = old === Infinity ? Math.min(2 * patience, LONGEST_PATIENCE) : PATIENCE;
    if (canDrawIn3d()) return load();
    [loadedAt, deadSince] = [now, Infinity]; // try again later: a browser may give the context back
    tell("webgl");
  };
  const load = () => {
    [loadedAt, deadSince, wasLive, calm] = [performance.now(), Infinity, false, 0];
    frame.remove();
    frame = make();
    element.prepend(frame);
  };
  const timer = setInterval(look, LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  /** @param {boolean} is */
  const setWanted = (is) => {
    if (is === isWanted) return;
    isWanted = is;
    write(paceWords, "");
    if (is) load();
    else frame.remove();
    tell("coming");
  };
  /** With plots the frame must not become too narrow, because they stand beside the picture. @param {boolean} is */
  const setPlots = (is) => {
    hasPlots = is;
    draw(element, is ? Math.max(1, Math.min(coarse, element.clientWidth / PLOTS_WIDTH)) : coarse);
  };
  return { element, surface, why: () => why, setWanted, setPlots };
}

/** The state of the picture in a frame; undefined while its page has none. @param {HTMLIFrameElement} frame */
function pictureOf(frame) {
  try {
    return frame.contentWindow?.bodydriveView;
  } catch {
    return undefined; // a frame with an error page cannot be read
  }
}

/** @param {number} rate pictures a second @param {number | null} age s @param {number} coarse */
function paceSentence(rate, age, coarse) {
  const isSlow = rate < SLOW && coarse >= COARSEST;
  const figures = { rate: number(rate, 0), age: age === null ? "–" : number(1000 * age, 0) };
  return t(isSlow ? "trial-view-pace-slow" : "trial-view-pace", figures);
}

/** @param {HTMLElement} element @param {number} times screen pixels to one drawn pixel, each way */
function draw(element, times) {
  element.style.setProperty("--coarse", String(times));
}
