/** A place for a chart, which comes when what draws it was loaded. */
import { failureWords } from "../api.js";
import { h, useLayoutEffect, useRef, useSignal } from "../preact.js";

/**
 * @param {object} place
 * @param {import("../main.js").App} place.app @param {AbortSignal} place.left
 * @param {unknown[]} place.of what the chart shows: it is drawn again when one of these changes
 * @param {(until: AbortSignal) => Promise<Node>} place.make
 */
export function ChartPlace({ app, left, of, make }) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  const isDrawn = useSignal(false);
  useLayoutEffect(() => {
    const replaced = new AbortController();
    const until = AbortSignal.any([left, replaced.signal]);
    make(until).then(
      (chart) => {
        if (until.aborted) return;
        place.current?.replaceChildren(chart);
        isDrawn.value = true;
      },
      (error) => until.aborted || app.toasts.show(failureWords(error)),
    );
    return () => replaced.abort();
  }, of);
  return h("div", { class: isDrawn.value ? undefined : "chart", ref: place }); // until then as high as the chart
}
