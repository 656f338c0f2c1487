/** The cross of the two-minute test: the target, the dot that is moved into it, and how long it has been inside. */
import { t } from "../texts.js";
import { s, set } from "../widgets/dom.js";

const ARM = 100; // length of an arm of the cross
const DOT = 5;
const RING = 3; // beyond the target's edge

/** @typedef {import("types/api").TestMoment} TestMoment */

export function targetCross() {
  const target = s("circle", { class: "target" });
  const ring = s("circle", { class: "ring", transform: "rotate(-90)" });
  const goal = s("g", { visibility: "hidden" }, target, ring);
  const dot = s("circle", { class: "dot", r: DOT });
  const element = s(
    "svg",
    { class: "target-cross", viewBox: "-116 -116 232 232", role: "img", "aria-label": t("test-cross") },
    s("line", { x1: -ARM, x2: ARM }),
    s("line", { y1: -ARM, y2: ARM }),
    goal,
    dot,
  );
  /** @param {TestMoment | null} now null: no test is running */
  const show = (now) => {
    const [ahead, left] = now?.cursor ?? [0, 0];
    set(dot, { cx: -ARM * (left ?? 0), cy: -ARM * (ahead ?? 0) });
    const place = now?.target;
    set(goal, { visibility: place ? "visible" : "hidden" });
    if (!now || !place) return;
    const radius = ARM * (now.radius ?? 0);
    const around = 2 * Math.PI * (radius + RING);
    set(goal, { transform: `translate(${-ARM * (place[1] ?? 0)} ${-ARM * (place[0] ?? 0)})` });
    set(target, { r: radius });
    set(ring, { r: radius + RING, "stroke-dasharray": around, "stroke-dashoffset": around * (1 - (now.dwell ?? 0)) });
  };
  show(null);
  return { element, show };
}
