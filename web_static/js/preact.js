/**
 * What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`.
 * @import { ComponentChild } from "../vendor/preact/preact.js"
 * @typedef {import("../vendor/preact/preact.js").ComponentChildren} ComponentChildren
 */
/** @template Props @typedef {import("../vendor/preact/preact.js").VNode<Props>} VNode */
/** @template Element @typedef {import("../vendor/preact/preact.js").Ref<Element>} Ref */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").ReadonlySignal<Value>} ReadonlySignal */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").Signal<Value>} Signal */
import { useLayoutEffect, useRef } from "../vendor/preact/hooks.js";
import { render } from "../vendor/preact/preact.js";

export { cloneElement, createRef, Fragment, h, render } from "../vendor/preact/preact.js";
export { useLayoutEffect, useMemo, useRef, useState } from "../vendor/preact/hooks.js";
export { computed, signal, useComputed, useSignal } from "../vendor/@preact/signals/signals.js";

/**
 * Show a page in place of what was shown, in an element of its own.
 * @param {HTMLElement} root the place of the pages @param {ComponentChild} page @param {string} [kind] classes of the element
 */
export function drawPage(root, page, kind = "body") {
  const element = document.createElement("div");
  element.className = kind;
  root.replaceChildren(element); // first, because only a control in the document can take the focus
  render(page, element);
}

/** A `ref` of a control that has the focus as soon as it appears. @param {HTMLElement | null} control */
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
