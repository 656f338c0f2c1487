/** Fingers, mouse and wheel on the drawing: taps, drags, pinches. */

const STILL = 10; // px that a tap may wander
const WHEEL = 0.0015; // zoom per px of a wheel's turn

/**
 * @param {SVGElement} element
 * @param {{
 *   tap: (pixel: [number, number]) => void,
 *   hover: (pixel: [number, number] | null) => void,
 *   grab: (pixel: [number, number]) => boolean,
 *   drag: (from: [number, number], to: [number, number]) => void,
 *   drop: () => void,
 *   pan: (dx: number, dy: number) => void,
 *   zoom: (factor: number, pixel: [number, number]) => void,
 * }} on grab: whether a thing is taken along by a drag that begins there; otherwise the drawing itself is
 * @param {AbortSignal} signal
 */
export function listenToPointers(element, on, signal) {
  /** @type {Map<number, [number, number]>} */
  const down = new Map();
  let start = null; // where the only finger came down; null as soon as it cannot be a tap any more
  let isHeld = false;
  let isSpace = false;
  const pixel = (event) => {
    const { left, top } = element.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const listen = (name, act, target = element) => target.addEventListener(name, act, { signal, passive: false });

  listen("pointerdown", (event) => {
    if (event.button > 1) return;
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, pixel(event));
    if (isHeld) on.drop();
    isHeld = false;
    start = down.size === 1 ? { at: pixel(event), wandered: false, pans: isSpace || event.button === 1 } : null;
  });
  listen("pointermove", (event) => {
    const now = pixel(event);
    const before = down.get(event.pointerId);
    if (!before) return on.hover(now);
    if (down.size === 2) pinch(event.pointerId, before, now);
    else if (start) wander(before, now);
    down.set(event.pointerId, now);
  });
  const up = (event) => {
    if (!down.delete(event.pointerId)) return;
    if (isHeld) on.drop();
    else if (start && !start.wandered && event.type === "pointerup" && !start.pans) on.tap(start.at);
    isHeld = false;
    start = null;
  };
  listen("pointerup", up);
  listen("pointercancel", up);
  listen("pointerleave", () => on.hover(null));
  listen("wheel", (event) => {
    event.preventDefault();
    on.zoom(Math.exp(-event.deltaY * WHEEL), pixel(event));
  });
  listen("keydown", (event) => event.code === "Space" && !event.defaultPrevented && (isSpace = true), window);
  listen("keyup", (event) => event.code === "Space" && (isSpace = false), window);

  function wander(before, now) {
    if (!start.wandered) {
      if (Math.hypot(now[0] - start.at[0], now[1] - start.at[1]) < STILL) return;
      start.wandered = true;
      isHeld = !start.pans && on.grab(start.at);
      if (!isHeld) on.pan(now[0] - start.at[0], now[1] - start.at[1]);
      return;
    }
    if (isHeld) on.drag(start.at, now);
    else on.pan(now[0] - before[0], now[1] - before[1]);
  }

  function pinch(id, before, now) {
    const [, other] = [...down].find(([one]) => one !== id);
    const apart = (a) => Math.max(20, Math.hypot(a[0] - other[0], a[1] - other[1]));
    on.zoom(apart(now) / apart(before), [(now[0] + other[0]) / 2, (now[1] + other[1]) / 2]);
    on.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  }
}
