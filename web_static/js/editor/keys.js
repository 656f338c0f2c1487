/** Keys on the drawing, and undo wherever one is on the page. */
import { isWriting } from "../shell/stop.js";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const FAR = 10; // steps with the shift key

/**
 * @param {Element} sheet
 * @param {{arrow: (x: number, y: number) => void, enter: () => void, escape: () => void, zoom: (isNearer: boolean) => void, erase: () => void, undo: () => void, redo: () => void}} on
 * arrow: in steps, y up
 * @param {AbortSignal} signal
 */
export function listenToKeys(sheet, on, signal) {
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
  const anywhere = (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || isWriting(event.target)) return;
    event.preventDefault();
    if (event.shiftKey) on.redo();
    else on.undo();
  };
  sheet.addEventListener("keydown", onSheet, { signal });
  window.addEventListener("keydown", anywhere, { signal });
}
