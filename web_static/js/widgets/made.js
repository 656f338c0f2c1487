/** What Preact shows without drawing it: elements that are made by hand, and listeners that end with a component. */
import { h, useLayoutEffect, useRef } from "../preact.js";

/**
 * Start something when a component appears; its signal is aborted when the component disappears or the page is left.
 * @param {AbortSignal} left the signal of the page @param {(gone: AbortSignal) => void} start
 */
export function useUntilGone(left, start) {
  useLayoutEffect(() => {
    const gone = new AbortController();
    start(AbortSignal.any([left, gone.signal]));
    return () => gone.abort();
  }, []);
}

/**
 * A place for an element that is made by hand.
 * @param {{left: AbortSignal, make: (gone: AbortSignal) => Node, class?: string}} made
 */
export function Made({ left, make, class: kind }) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  useUntilGone(left, (gone) => place.current?.append(make(gone)));
  return h("div", { class: kind, ref: place });
}
