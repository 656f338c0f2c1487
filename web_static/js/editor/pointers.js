/** Fingers, mouse and wheel on the drawing: taps, drags, pinches. */

const STILL = 10; // px that a tap may wander
const WHEEL = 0.0015; // zoom per px of a wheel's turn

/** @typedef {[number, number]} Pixel from the upper left of the drawing */

/**
 * @typedef {object} PointerActions
 * @property {(pixel: Pixel) => void} tap
 * @property {(pixel: Pixel | null) => void} hover
 * @property {(pixel: Pixel) => boolean} grab whether a drag that begins here moves an item; otherwise it moves the drawing
 * @property {(from: Pixel, to: Pixel) => void} drag
 * @property {() => void} drop
 * @property {(dx: number, dy: number) => void} pan
 * @property {(factor: number, pixel: Pixel) => void} zoom
 */

/** @param {SVGElement} element @param {PointerActions} on @param {AbortSignal} signal */
export function listenToPointers(element, on, signal) {
  /** @type {Map<number, Pixel>} */
  const down = new Map();
  /**
   * The only finger that is down; null as soon as it cannot tap any more.
   * @type {{at: Pixel, isDrag: boolean, pans: boolean} | null}
   */
  let start = null;
  let hasItem = false;
  let isSpace = false;
  /** @param {MouseEvent} event @returns {Pixel} */
  const pixel = (event) => {
    const { left, top } = element.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const options = { signal, passive: false };

  element.addEventListener("pointerdown", onDown, options);
  element.addEventListener("pointermove", onMove, options);
  element.addEventListener("pointerup", onUp, options);
  element.addEventListener("pointercancel", onUp, options);
  element.addEventListener("pointerleave", () => on.hover(null), options);
  element.addEventListener("wheel", onWheel, options);
  window.addEventListener(
    "keydown",
    (event) => isSpaceKey(event) && !event.defaultPrevented && (isSpace = true),
    options,
  );
  window.addEventListener("keyup", (event) => isSpaceKey(event) && (isSpace = false), options);

  /** @param {PointerEvent} event */
  function onDown(event) {
    if (event.button > 1) return;
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, pixel(event));
    if (hasItem) on.drop();
    hasItem = false;
    start = down.size === 1 ? { at: pixel(event), isDrag: false, pans: isSpace || event.button === 1 } : null;
  }

  /** @param {PointerEvent} event */
  function onMove(event) {
    const now = pixel(event);
    const before = down.get(event.pointerId);
    if (!before) return on.hover(now);
    if (down.size === 2) pinch(event.pointerId, before, now);
    else if (start) drag(start, before, now);
    down.set(event.pointerId, now);
  }

  /** @param {PointerEvent} event */
  function onUp(event) {
    if (!down.delete(event.pointerId)) return;
    if (hasItem) on.drop();
    else if (start && !start.isDrag && event.type === "pointerup" && !start.pans) on.tap(start.at);
    hasItem = false;
    start = null;
  }

  /** @param {WheelEvent} event */
  function onWheel(event) {
    event.preventDefault();
    on.zoom(Math.exp(-event.deltaY * WHEEL), pixel(event));
  }

  /** @param {NonNullable<typeof start>} from @param {Pixel} before @param {Pixel} now */
  function drag(from, before, now) {
    if (!from.isDrag) {
      if (Math.hypot(now[0] - from.at[0], now[1] - from.at[1]) < STILL) return;
      from.isDrag = true;
      hasItem = !from.pans && on.grab(from.at);
      if (!hasItem) on.pan(now[0] - from.at[0], now[1] - from.at[1]);
      return;
    }
    if (hasItem) on.drag(from.at, now);
    else on.pan(now[0] - before[0], now[1] - before[1]);
  }

  /** @param {number} id of the finger that moves @param {Pixel} before @param {Pixel} now */
  function pinch(id, before, now) {
    const other = [...down].find(([one]) => one !== id)?.[1];
    if (!other) return;
    /** @param {Pixel} a */
    const apart = (a) => Math.max(20, Math.hypot(a[0] - other[0], a[1] - other[1]));
    on.zoom(apart(now) / apart(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
    on.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  }
}

/** @param {KeyboardEvent} event */
function isSpaceKey(event) {
  return event.code === "Space";
}
