/**
 * What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`.
 * @typedef {import("../vendor/preact/preact.js").ComponentChildren} ComponentChildren
 */
/** @template Props @typedef {import("../vendor/preact/preact.js").VNode<Props>} VNode */
/** @template Element @typedef {import("../vendor/preact/preact.js").Ref<Element>} Ref */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").ReadonlySignal<Value>} ReadonlySignal */
/** @template Value @typedef {import("../vendor/@preact/signals/signals.js").Signal<Value>} Signal */
import { useSignal } from "../vendor/@preact/signals/signals.js";
import { useLayoutEffect, useRef } from "../vendor/preact/hooks.js";
import { Fragment, h, render } from "../vendor/preact/preact.js";
import { giveFocus } from "./focus.js";

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

/**
 * A `ref` of a control that has the focus as soon as it appears, and gives it back when it goes.
 * @param {HTMLElement | null} control
 */
export function focusFirst(control) {
  const before = document.activeElement;
  control?.focus();
  return () => {
    if (document.activeElement !== document.body) queueMicrotask(() => giveFocus(before));
  };
}

/**
 * The `ref` of a place in which something opens: each time, it comes into view, and its first control has the focus.
 * When it closes, what opened it has the focus again, otherwise the first button of the place.
 * @param {unknown} opened what is open, another value each time; null: nothing @param {string} [first] selector of that control
 */
export function useOpening(opened, first = "input") {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  const before = useRef(/** @type {Element | null} */ (null)); // what had the focus when it opened; null: it is closed
  useLayoutEffect(() => {
    const { current: element } = place;
    if (opened) {
      before.current ??= document.activeElement;
      element?.scrollIntoView({ block: "nearest" });
      /** @type {HTMLElement | null | undefined} */ (element?.querySelector(first))?.focus();
    } else if (before.current) {
      giveFocus(before.current, element?.querySelector("button"));
      before.current = null;
    }
  }, [opened]);
  return place;
}

/** A part that stands in place of its button while it is open; when it closes, the button has the focus by `buttonRef`. */
export function useOpenForm() {
  const isOpen = useSignal(false);
  const wasOpen = useRef(false);
  const open = () => void (isOpen.value = wasOpen.current = true);
  const close = () => void (isOpen.value = false);
  return { isOpen: isOpen.value, open, close, buttonRef: wasOpen.current ? focusFirst : null };
}

/**
 * Keep the focus in a part of a page whose controls replace each other: when the one that had it is gone, the first of
 * `next` has it that can, otherwise the heading of the page.
 * @param {string} part selector @param {...string} next selectors
 */
export function useFocusWithin(part, ...next) {
  const hadFocus = Boolean(document.activeElement?.closest(part));
  useLayoutEffect(() => {
    if (hadFocus) giveFocus(...next.flatMap((one) => [...document.querySelectorAll(one)]));
  });
}
