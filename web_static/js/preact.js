/**
 * What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`.
 * @import { ComponentChild } from "../vendor/preact/preact.js"
 */
import { useLayoutEffect, useRef } from "../vendor/preact/hooks.js";
import { render } from "../vendor/preact/preact.js";

export { cloneElement, createRef, Fragment, h, render } from "../vendor/preact/preact.js";
export { useLayoutEffect, useState } from "../vendor/preact/hooks.js";
export { signal, useSignal } from "../vendor/@preact/signals/signals.js";

/**
 * Show a page in an element of its own, in place of what was shown.
 * @param {HTMLElement} root the place of the pages @param {ComponentChild} page @param {string} [kind] classes of the element
 */
export function drawPage(root, page, kind = "body") {
  const body = document.createElement("div");
  body.className = kind;
  root.replaceChildren(body); // a control that takes the focus when it appears has to be in the document
  render(page, body);
}

/** A `ref` that focuses a control when it appears, not when it is drawn again. @param {HTMLElement | null} control */
export const focusFirst = (control) => control?.focus();

/**
 * The `ref` of a place in which something opens: each time, it comes into view, and its first control has the focus.
 * @param {unknown} opened what is open, another value each time; null: nothing @param {string} [first] selector of that control
 */
export function useOpening(opened, first = "input") {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    if (!opened) return;
    place.current?.scrollIntoView({ block: "nearest" });
    /** @type {HTMLElement | null | undefined} */ (place.current?.querySelector(first))?.focus();
  }, [opened]);
  return place;
}
