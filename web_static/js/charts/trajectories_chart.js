/** All trajectories over the path, as in the paper's figure, with a scale of metres. */
import { t } from "../texts.js";
import { h, s } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { points } from "../plan/plan_marks.js";
import { limits } from "./extent.js";
import { legendItems } from "./symbols.js";
import { showTips } from "./tips.js";

const AROUND = 0.8; // m of the building shown around what was driven
const SCALES = [0.5, 1, 2, 5, 10, 20, 50, 100]; // m
const SCALE_SHARE = 0.25; // of the picture's width that the scale has at most

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @typedef {import("types/api").TrajectoriesView} TrajectoriesView
 */

/**
 * @param {TrajectoriesView} driven
 * @param {Pick<import("../plan/floor_plan.js").FloorPlan, "walls"> | null} plan @param {AbortSignal} signal
 */
export async function trajectoriesChart({ path, trajectories }, plan, signal) {
  const lines = trajectories.map(({ x, y }) => x.map((value, i) => /** @type {Point} */ ([value, y[i]])));
  const box = boxAround([...path, ...lines.flat()]);
  const newest = lines.length - 1;
  const opacity = 0.8 * Math.max(0.4, 1 / Math.max(1, lines.length ** 0.4)); // of the earlier ones
  const dash = matchMedia("(forced-colors: active)").matches ? [8, 6] : undefined; // of the path, beside few colours
  const picture = s(
    "svg",
    { class: "trajectories", viewBox: box.join(" "), "aria-hidden": "true" },
    s(
      "g",
      { transform: "scale(1 -1)" }, // the plan's y goes up, the picture's down
      (plan?.walls ?? []).map((wall) => s("polyline", { class: "wall", points: points(wall) })),
      lines.map((line, i) =>
        s("polyline", {
          class: i === newest ? "newest" : "earlier",
          points: points(line),
          "stroke-opacity": i === newest ? null : opacity,
        }),
      ),
      s("polyline", { class: "path", points: points(path), "stroke-dasharray": dash?.join(" ") }),
    ),
  );
  const place = h(
    "div",
    { class: "plot", role: "img", "aria-label": t("review-trajectories") },
    picture,
    scale(box[2], box[3]),
  );
  showTips(place, () => pointsIn(picture, trajectories), signal);
  const drivenColour = "var(--path-driven)";
  const legend = legendItems([
    { name: newest > 0 ? t("review-earlier") : undefined, line: { colour: drivenColour, width: 1.5 } },
    { name: newest >= 0 ? t("review-newest") : undefined, line: { colour: drivenColour, width: 3 } },
    {
      name: path.length ? t("review-path-line") : undefined,
      line: { colour: "var(--path-prescribed)", width: 3, dash },
    },
  ]);
  return h("figure", { class: "chart" }, h("ul", { class: "chart-legend" }, legend), place);
}

/** The view box around some points, whose y goes up. @param {Point[]} all */
function boxAround(all) {
  const shown = all.length ? all : [[0, 0]];
  const [left, right] = limits(shown.map(([x]) => x));
  const [low, high] = limits(shown.map(([, y]) => y));
  return [left - AROUND, -high - AROUND, right - left + 2 * AROUND, high - low + 2 * AROUND];
}

/**
 * A line as long as its metres are in a picture of some size; css/charts/chart.css computes its length.
 * @param {number} width m @param {number} height m
 */
function scale(width, height) {
  const metres = SCALES.findLast((length) => length <= width * SCALE_SHARE) ?? SCALES[0];
  const style = `--metres: ${metres}; --width: ${width}; --height: ${height}`;
  return h("span", { class: "scale", style }, `${number(metres, metres < 1 ? 1 : 0)} m`);
}

/**
 * The points of the trajectories, in px of the window.
 * @param {SVGSVGElement} picture @param {TrajectoriesView["trajectories"]} trajectories
 */
function pointsIn(picture, trajectories) {
  const matrix = picture.getScreenCTM();
  if (!matrix) return [];
  const { a: pixels, e: left, f: top } = matrix;
  return trajectories.flatMap(({ number, x, y }) =>
    x.map((value, i) => ({
      x: left + pixels * value,
      y: top - pixels * y[i],
      words: () => t("review-trial-line", { number }),
    })),
  );
}
