/**
 * What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`.
 * @typedef {import("../vendor/preact/preact.js").ComponentChildren} ComponentChildren
 */
/** @template Props @typedef {import("../vendor/preact/preact.js").VNode<Props>} VNode */
/** @template Element @typedef {import("../vendor/preact/preact.js").Ref<Element>} Ref */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").ReadonlySignal<Value>} ReadonlySignal */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").Signal<Value>} Signal */
import { useLayoutEffect, useRef } from "../vendor/preact/hooks.js";
import { Fragment, h, render } from "../vendor/preact/preact.js";

export { cloneElement, createRef, Fragment, h, render } from "../vendor/preact/preact.js";
export { useLayoutEffect, useMemo, useRef, useState } from "../vendor/preact/hooks.js";
export { computed, effect, signal, useComputed, useSignal } from "../vendor/@preact/signals/signals.js";

/**
 * Show a page in place of what was shown, in an element of its own.
 * @param {HTMLElement} root the place of the pages @param {ComponentChildren} page @param {string} [kind] classes of the element
 */
export function drawPage(root, page, kind = "body") {
  root.replaceChildren();
  drawPart(root, page, kind);
}

/** Show the foot of a page, after `drawPage`. @param {HTMLElement} root @param {ComponentChildren} foot */
export function drawFoot(root, foot) {
  drawPart(root, foot, "foot");
}

/** @param {HTMLElement} root @param {ComponentChildren} part @param {string} kind classes of the element */
function drawPart(root, part, kind) {
  const element = document.createElement("div");
  element.className = kind;
  root.append(element); // first, because only a control in the document can take the focus
  render(h(Fragment, {}, part), element);
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
