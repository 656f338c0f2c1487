/** The keys of the editor: on the drawing, and undo anywhere on the page. */
import { isWriting } from "../shell/stop.js";

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const FAR = 10; // steps with the shift key

/**
 * @typedef {object} KeyActions
 * @property {(x: number, y: number) => void} arrow in steps, y up
 * @property {() => void} enter
 * @property {() => void} escape
 * @property {(isNearer: boolean) => void} zoom
 * @property {() => void} erase
 * @property {() => void} undo
 * @property {() => void} redo
 */

/** @param {SVGElement} sheet @param {KeyActions} on @param {AbortSignal} signal */
export function listenToKeys(sheet, on, signal) {
  /** @param {KeyboardEvent} event */
  const onSheet = (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) {
      event.preventDefault();
      const [x, y] = arrow.map((one) => one * (event.shiftKey ? FAR : 1));
      on.arrow(x, y);
    } else if (event.key === "Enter") on.enter();
    else if (event.key === "Escape") on.escape();
    else if (event.key === "+" || event.key === "-") on.zoom(event.key === "+");
    else if (event.key === "Delete" || event.key === "Backspace") on.erase();
  };
  /** @param {KeyboardEvent} event */
  const anywhere = (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || isWriting(event.target)) return;
    event.preventDefault();
    if (event.shiftKey) on.redo();
    else on.undo();
  };
  sheet.addEventListener("keydown", onSheet, { signal });
  window.addEventListener("keydown", anywhere, { signal });
}
