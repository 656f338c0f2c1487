/**
 * A gesture's live bar with its two handles: from here it counts, here it is full. Pointer, arrow keys and − + all move
 * them.
 * @import { Gesture } from "types/api"
 * @import { ControlsStore } from "./store.js"
 * @typedef {"from" | "full"} HandleName
 */
import { Fragment, h, useRef } from "../../preact.js";
import { t } from "../../texts.js";
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

/** @param {{store: ControlsStore, gesture: Gesture, words: string}} bar words: of the gesture */
export function HandleBar({ store, gesture, words }) {
  const bar = useRef(/** @type {HTMLDivElement | null} */ (null));
  const pointerHandle = useRef(/** @type {HandleName | null} */ (null)); // the handle that the pointer has
  const length = useRef(0);
  // It is never made shorter, because the handle would move under the finger.
  if (gesture.full > length.current) length.current = lengthFor(gesture);
  const { current: end } = length;
  const at = { from: gesture.dead_zone, full: gesture.full };
  /** @param {number} value @returns {number} % of the bar */
  const share = (value) => (100 * Math.min(end, Math.max(0, value))) / end;
  /** @param {HandleName} which @param {number} value */
  const move = (which, value) => {
    const bounded =
      which === "from"
        ? Math.min(at.full - LEAST_GAP, Math.max(0, value))
        : Math.min(end, Math.max(at.from + LEAST_GAP, value));
    const rounded = Number(bounded.toFixed(3));
    if (rounded === at[which]) return;
    if (which === "from") store.setHandles(gesture.name, rounded, at.full);
    else store.setHandles(gesture.name, at.from, rounded);
  };
  /** @param {KeyboardEvent} event @param {HandleName} which */
  const press = (event, which) => {
    const step = STEPS[event.key];
    const value = event.key === "Home" ? 0 : event.key === "End" ? end : step ? at[which] + step : null;
    if (value === null) return;
    event.preventDefault();
    move(which, value);
  };
  /** A pointer takes the nearer handle when it lands near one. @param {PointerEvent} event */
  const grab = (event) => {
    const { current: element } = bar;
    if (!element) return;
    const { left, width } = element.getBoundingClientRect();
    /** @param {HandleName} which @returns {number} px */
    const distance = (which) => Math.abs(event.clientX - left - (width * share(at[which])) / 100);
    const nearer = distance("from") < distance("full") ? "from" : "full";
    if (distance(nearer) > GRAB) return;
    event.preventDefault();
    pointerHandle.current = nearer;
    element.setPointerCapture(event.pointerId);
    /** @type {HTMLElement | null} */ (element.querySelector(`[data-handle="${nearer}"]`))?.focus({
      preventScroll: true,
    });
  };
  /** @param {PointerEvent} event */
  const drag = (event) => {
    if (!bar.current || !pointerHandle.current) return;
    const { left, width } = bar.current.getBoundingClientRect();
    move(pointerHandle.current, ((event.clientX - left) / width) * end);
  };
  const release = () => void (pointerHandle.current = null);
  /** @param {HandleName} which */
  const valueOf = (which) => t(`handle-${gesture.feature}`, { value: number(100 * at[which], 0) });
  const isCrowded = share(at.full) - share(at.from) < CROWDED;
  return h(
    "div",
    { class: "handle-bar" },
    h(
      "div",
      {
        class: "handles",
        ref: bar,
        onPointerDown: grab,
        onPointerMove: drag,
        onPointerUp: release,
        onPointerCancel: release,
      },
      h(Level, { store, gesture, share }),
      HANDLES.map((which) =>
        h("div", {
          key: which,
          class: "handle",
          "data-handle": which,
          role: "slider",
          tabindex: 0,
          "aria-label": t(`handle-${which}-label`, { gesture: words }),
          "aria-valuemin": 0,
          "aria-valuemax": end,
          "aria-valuenow": Number(at[which].toFixed(2)),
          "aria-valuetext": valueOf(which),
          style: { left: `${share(at[which])}%` },
          onKeyDown: (/** @type {KeyboardEvent} */ event) => press(event, which),
        }),
      ),
    ),
    h(
      "div",
      { class: "under", "aria-hidden": "true" },
      HANDLES.map((which) =>
        h(
          "span",
          {
            key: which,
            class: "words",
            "data-turn": turnOf(which, isCrowded, share(at[which])),
            style: { left: `${share(at[which])}%` },
          },
          t(`handle-value-${which}`, { value: valueOf(which) }),
        ),
      ),
    ),
  );
}

/**
 * How strong the movement is now, and how strong it was at most in the last seconds.
 * @param {{store: ControlsStore, gesture: Gesture, share: (value: number) => number}} level
 */
function Level({ store: { live }, gesture, share }) {
  const peak = useRef({ value: 0, at: 0 });
  const value = live.value?.rate[live.value.gestures.indexOf(gesture.name)] ?? 0;
  const now = performance.now();
  if (value >= peak.current.value || now - peak.current.at > PEAK_STAYS)
    peak.current = { value: Math.max(0, value), at: now };
  return h(
    Fragment,
    {},
    h("div", { class: value > gesture.dead_zone ? "live counts" : "live", style: { width: `${share(value)}%` } }),
    h("div", { class: "peak", style: { left: `${share(peak.current.value)}%` } }),
  );
}

/** Where the bar of a gesture ends, so that its upper handle has room. @param {Gesture} gesture */
function lengthFor({ feature, full }) {
  return Math.ceil(Math.max(SHORTEST[feature], full * 1.35) * 5) / 5;
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
