/**
 * A gesture's live bar with its two handles: from here it counts, here it is full. Pointer, arrow keys and − + all move them.
 * @import { Gesture } from "types/api"
 * @typedef {"from" | "full"} HandleName
 */
import { t } from "../../texts.js";
import { h, set, write } from "../../widgets/dom.js";
import { number } from "../../widgets/format.js";

const LEAST_GAP = 0.02; // FS/s or FS between the handles; the server refuses less than 0.01
const FINE = 0.01; // one arrow key
const COARSE = 0.1; // page up and down
const GRAB = 44; // px around a handle that takes hold of it
const PEAK_STAYS = 3000; // ms: long enough to see how far a movement went
const CROWDED = 26; // % of the bar: closer handles have their words turned outwards
const HANDLES = /** @type {const} */ (["from", "full"]);
/** What a key moves a handle by. @type {Record<string, number | undefined>} */
const STEPS = {
  ArrowRight: FINE,
  ArrowUp: FINE,
  ArrowLeft: -FINE,
  ArrowDown: -FINE,
  PageUp: COARSE,
  PageDown: -COARSE,
};
const SHORTEST = { rate: 1.2, displacement: 1 }; // the bar's end at least

/**
 * @param {Gesture} gesture @param {string} name for people @param {(dead_zone: number, full: number) => void} onChange
 */
export function handleBar(gesture, name, onChange) {
  const end = Math.ceil(Math.max(SHORTEST[gesture.feature], gesture.full * 1.35) * 5) / 5;
  const at = { from: gesture.dead_zone, full: gesture.full };
  const live = h("div", { class: "live" });
  const peak = h("div", { class: "peak" });
  const handles = { from: handle("from", name), full: handle("full", name) };
  const words = { from: h("span", { class: "words" }), full: h("span", { class: "words" }) };
  const bar = h("div", { class: "handles" }, live, peak, handles.from, handles.full);
  const element = h(
    "div",
    { class: "handle-bar" },
    bar,
    h("div", { class: "under", "aria-hidden": "true" }, words.from, words.full),
  );

  /** @param {number} value */
  const share = (value) => (100 * Math.min(end, Math.max(0, value))) / end;
  const show = () => {
    const isCrowded = share(at.full) - share(at.from) < CROWDED;
    for (const which of HANDLES) {
      const value = t(`handle-${gesture.feature}`, { value: number(100 * at[which], 0) });
      handles[which].style.left = words[which].style.left = `${share(at[which])}%`;
      write(words[which], t(`handle-value-${which}`, { value }));
      words[which].dataset.turn = turnOf(which, isCrowded, share(at[which]));
      set(handles[which], {
        "aria-valuemin": 0,
        "aria-valuemax": end,
        "aria-valuenow": Number(at[which].toFixed(2)),
        "aria-valuetext": value,
      });
    }
  };
  /** @param {HandleName} which @param {number} value */
  const move = (which, value) => {
    const bounded =
      which === "from"
        ? Math.min(at.full - LEAST_GAP, Math.max(0, value))
        : Math.min(end, Math.max(at.from + LEAST_GAP, value));
    const rounded = Number(bounded.toFixed(3));
    if (rounded === at[which]) return;
    at[which] = rounded;
    show();
    onChange(at.from, at.full);
  };
  for (const which of HANDLES) {
    handles[which].addEventListener("keydown", (event) => {
      const step = STEPS[event.key];
      const value = event.key === "Home" ? 0 : event.key === "End" ? end : step ? at[which] + step : null;
      if (value === null) return;
      event.preventDefault();
      move(which, value);
    });
  }
  dragNearest(bar, handles, (which, x) => move(which, x * end));
  show();

  let highest = 0;
  let highestAt = 0;
  /** @param {number} value */
  const showLive = (value) => {
    const now = performance.now();
    if (value >= highest || now - highestAt > PEAK_STAYS) [highest, highestAt] = [Math.max(0, value), now];
    live.style.width = `${share(value)}%`;
    live.classList.toggle("counts", value > at.from);
    peak.style.left = `${share(highest)}%`;
  };
  /** @param {number} from @param {number} full */
  const setHandles = (from, full) => {
    [at.from, at.full] = [from, full];
    show();
  };
  return { element, showLive, setHandles };
}

/** @param {HandleName} which @param {string} name of the gesture for people */
function handle(which, name) {
  return h("div", {
    class: "handle",
    "data-handle": which,
    role: "slider",
    tabindex: "0",
    "aria-label": t(`handle-${which}-label`, { gesture: name }),
  });
}

/**
 * Which way the words under a handle run, so that they neither overlap nor leave the bar.
 * @param {HandleName} which @param {boolean} isCrowded @param {number} share in %
 */
function turnOf(which, isCrowded, share) {
  if (share < 12) return "right";
  if (share > 88) return "left";
  return isCrowded ? (which === "from" ? "left" : "right") : "middle";
}

/**
 * Let a pointer drag the nearer handle when it lands near one.
 * @param {HTMLElement} bar @param {Record<HandleName, HTMLElement>} handles
 * @param {(which: HandleName, share: number) => void} onMove
 */
function dragNearest(bar, handles, onMove) {
  /** @type {HandleName | null} */
  let taken = null;
  /** @param {PointerEvent} event */
  const place = (event) => {
    const box = bar.getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, width: box.width };
  };
  bar.addEventListener("pointerdown", (event) => {
    /** @param {HandleName} which */
    const away = (which) => {
      const box = handles[which].getBoundingClientRect();
      return Math.abs(event.clientX - (box.left + box.width / 2));
    };
    const nearer = away("from") < away("full") ? "from" : "full";
    taken = away(nearer) > GRAB ? null : nearer;
    if (!taken) return;
    event.preventDefault();
    bar.setPointerCapture(event.pointerId);
    handles[taken].focus({ preventScroll: true });
  });
  bar.addEventListener("pointermove", (event) => taken && onMove(taken, place(event).x));
  for (const name of ["pointerup", "pointercancel"]) bar.addEventListener(name, () => (taken = null));
}
