/** Where the focus goes when the control that has it is gone: to a neighbour, otherwise to the heading of the page. */

const ROW = "[role=listitem], tr, .plan-row, .foot, form, section";
const CONTROL = "button, a[href], input, select, textarea, summary";

/** @param {Element | null | undefined} element @returns {element is HTMLElement | SVGElement} */
function canHaveFocus(element) {
  if (!element?.isConnected || element === document.body) return false;
  return !element.closest("[inert]") && !element.matches(":disabled") && element.checkVisibility();
}

/**
 * When nothing has the focus, give it to the first of these that can have it, otherwise to the heading of the page.
 * @param {...(Element | null | undefined)} next
 */
export function giveFocus(...next) {
  if (canHaveFocus(document.activeElement)) return;
  [...next, ...document.querySelectorAll("main h1")].find(canHaveFocus)?.focus({ preventScroll: true });
}

/**
 * A `ref` of a control that may go because it was used: the focus then goes to the first control of the row or card
 * that it stood in, or of the one beside that.
 * @param {HTMLElement | null} control
 */
export function passFocus(control) {
  return () => {
    if (control !== document.activeElement) return;
    const row = control?.closest(ROW);
    const beside = row?.nextElementSibling ?? row?.previousElementSibling;
    queueMicrotask(() => giveFocus(row?.querySelector(CONTROL), beside?.querySelector(CONTROL)));
  };
}
