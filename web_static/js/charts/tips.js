/** The words over the nearest point of a chart: under a mouse, or after a tap until the next one beside the chart. */
import { h, write } from "../widgets/dom.js";

const REACH = 30; // px: a finger is not exact
const DISTANCE = 10; // px between a point and its words

/**
 * @typedef {object} ChartPoint
 * @property {number} x px in the window @property {number} y px in the window
 * @property {() => string} words what is said of the point
 * @property {number} [id] what a tap opens
 */

/**
 * @param {HTMLElement} place of the chart: the words are placed in it @param {() => Iterable<ChartPoint>} points
 * @param {AbortSignal} signal @param {(id: number) => void} [open] called with the id of a point after a tap on it
 */
export function showTips(place, points, signal, open) {
  const tip = h("div", { class: "chart-tip", hidden: true });
  place.append(tip);
  /** @param {ChartPoint | null} point */
  const show = (point) => {
    tip.hidden = !point;
    place.style.cursor = open && point?.id !== undefined ? "pointer" : "";
    if (!point) return;
    write(tip, point.words());
    const { left, top, width } = place.getBoundingClientRect();
    const above = point.y - top - DISTANCE - tip.offsetHeight;
    tip.style.left = `${Math.max(0, Math.min(point.x - left - tip.offsetWidth / 2, width - tip.offsetWidth))}px`;
    tip.style.top = `${above < 0 ? point.y - top + DISTANCE : above}px`;
  };
  /** A finger that scrolls the page moves over the chart, too. @param {PointerEvent} event */
  const hovers = ({ pointerType }) => pointerType !== "touch";
  place.addEventListener("pointermove", (event) => hovers(event) && show(nearest(points(), event)), { signal });
  place.addEventListener("pointerleave", (event) => hovers(event) && show(null), { signal });
  place.addEventListener(
    "click",
    (event) => {
      const point = nearest(points(), event);
      show(point);
      if (point?.id !== undefined) open?.(point.id);
    },
    { signal },
  );
  document.addEventListener("pointerdown", (event) => event.composedPath().includes(place) || show(null), { signal });
}

/** @param {Iterable<ChartPoint>} points @param {MouseEvent} event */
function nearest(points, { clientX, clientY }) {
  /** @type {ChartPoint | null} */
  let found = null;
  let least = REACH;
  for (const point of points) {
    const distance = Math.hypot(point.x - clientX, point.y - clientY);
    if (distance <= least) [found, least] = [point, distance];
  }
  return found;
}
