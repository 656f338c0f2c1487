/**
 * What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`.
 * @import { ComponentChild } from "../vendor/preact/preact.js"
 */
import { render } from "../vendor/preact/preact.js";

export { cloneElement, Fragment, h, render } from "../vendor/preact/preact.js";
export { useLayoutEffect, useRef, useState } from "../vendor/preact/hooks.js";
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
