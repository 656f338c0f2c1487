/**
 * Keeps the focus where a person can go on with the keyboard: when what has it disappears, it goes to what was drawn in
 * its place, otherwise to what opened it, otherwise to the heading of the page. A page that moves the focus itself comes
 * first: this looks only after the page has done what it does at once.
 */

const LONGEST = 12; // controls that were used last
const TEXT = "input:not([type=radio], [type=checkbox], [type=range], [type=button]), textarea";

/** What a control is called; a switch, by the label around it. @param {Element} element */
const nameOf = (element) =>
  element.getAttribute("aria-label") ?? (element.closest("label") ?? element).textContent?.trim() ?? "";

/** @param {Element} element */
const canHaveFocus = (element) =>
  element.isConnected && !element.closest("[inert]") && !element.matches(":disabled") && element.checkVisibility();

/**
 * The one control of the same kind and name, as it was drawn again; null when there is none, or more than one.
 * @param {Element} lost @returns {HTMLElement | SVGElement | null}
 */
function drawnAgain(lost) {
  const name = nameOf(lost);
  if (!name) return null;
  const same = [...document.querySelectorAll(lost.tagName)].filter((one) => nameOf(one) === name && canHaveFocus(one));
  return same.length === 1 ? /** @type {HTMLElement | SVGElement} */ (same[0]) : null;
}

/**
 * What gives the focus, once the page was drawn again, to the control that has it now, otherwise to the heading.
 * @param {HTMLElement} root @param {boolean} isSame whether it is the page that is shown, and not another one
 */
export function focusAgain(root, isSame) {
  const { activeElement: now } = document;
  const before = isSame && root.contains(now) ? now : null;
  return () => ((before && drawnAgain(before)) ?? root.querySelector("h1"))?.focus({ preventScroll: true });
}

/** Keep the focus from now on. */
export function keepFocus() {
  /** @type {Element | null} */
  let last = null;
  /** @type {Element[]} the newest last */
  let used = [];
  let byKey = false;
  document.addEventListener("focusin", ({ target }) => (last = target instanceof Element ? target : null));
  document.addEventListener("keydown", () => (byKey = true), true);
  document.addEventListener("pointerdown", () => (byKey = false), true);
  document.addEventListener(
    "click",
    () => {
      const { activeElement: now } = document;
      if (now && now !== document.body) used = [...used.filter((one) => one !== now), now].slice(-LONGEST);
    },
    true,
  );
  window.addEventListener("hashchange", () => (used = [])); // what was used on the page before
  const look = () => {
    const { activeElement: now } = document; // until the next picture, it may be something that has disappeared
    const lost = now === document.body ? last : now;
    if (!lost || canHaveFocus(lost)) return;
    const openers = used.filter((one) => one !== lost).map((one) => (canHaveFocus(one) ? one : drawnAgain(one)));
    const next =
      drawnAgain(lost) ?? openers.filter(Boolean).pop() ?? [...document.querySelectorAll("main h1")].find(canHaveFocus);
    last = null;
    // Without a keyboard, a field would open the one on the screen.
    if (next && (byKey || !next.matches(TEXT)))
      /** @type {HTMLElement | SVGElement} */ (next).focus({ preventScroll: true });
  };
  new MutationObserver(look).observe(document.body, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["hidden", "disabled", "inert", "open"],
  });
}
