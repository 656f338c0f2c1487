/** One small chart per joint with the traces of all its channels. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { jointLabel } from "../widgets/joint_words.js";
import { TraceCanvas } from "./traces.js";

export const QUIET_SPAN = 16; // times the noise: so that a body at rest shows a calm line instead of magnified noise

/**
 * @param {import("../live/live.js").Live} live
 * @param {{channels: {joint: string}[], joints: {name: string, label: string}[]}} layout
 * @param {AbortSignal} signal
 */
export function jointStrips(live, layout, signal) {
  const strips = layout.joints.map((joint) => {
    const indices = layout.channels.flatMap((channel, index) => (channel.joint === joint.name ? [index] : []));
    const canvas = new TraceCanvas({ label: t("traces-label", { joint: jointLabel(joint), count: indices.length }) });
    return { joint, indices, canvas };
  });
  live.addEventListener(
    "quality",
    () => {
      for (const { canvas, indices } of strips)
        canvas.floor = QUIET_SPAN * middle(indices.map((index) => live.noise[index]));
    },
    { signal },
  );
  drawTraces(
    live,
    strips.map(({ canvas, indices }) => ({
      canvas,
      values: (now) => indices.map((index) => now.values?.[index] ?? null),
    })),
    signal,
  );
  return h(
    "div",
    { class: "strips" },
    strips.map(({ joint, indices, canvas }) =>
      h(
        "div",
        { class: "strip" },
        h("span", {}, jointLabel(joint), h("small", {}, String(indices.length))),
        canvas.element,
      ),
    ),
  );
}

/** The median of the finite values; 0 without any. @param {(number | null | undefined)[]} values */
export function middle(values) {
  const finite = values.flatMap((value) => (typeof value === "number" && Number.isFinite(value) ? [value] : []));
  const sorted = finite.sort((a, b) => a - b);
  return sorted.length ? sorted[sorted.length >> 1] : 0;
}

/**
 * Feed canvases from the live link and draw them, until the page is left.
 * @typedef {import("../live/live.js").LiveMessage} LiveMessage
 * @param {import("../live/live.js").Live} live
 * @param {{canvas: TraceCanvas, values: (now: LiveMessage) => (number | null)[]}[]} traces
 * @param {AbortSignal} signal
 */
export function drawTraces(live, traces, signal) {
  let isFresh = false;
  live.addEventListener(
    "tick",
    ({ detail: now }) => {
      if (!now.values || now.t === null) return;
      for (const { canvas, values } of traces) canvas.push(now.t, values(now));
      isFresh = true;
    },
    { signal },
  );
  const draw = () => {
    if (signal.aborted) return;
    if (isFresh) for (const { canvas } of traces) canvas.draw();
    isFresh = false;
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
  signal.addEventListener("abort", () => traces.forEach(({ canvas }) => canvas.stop()));
}
