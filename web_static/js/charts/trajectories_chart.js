/** All trajectories over the path, as in the paper's figure. */
import { t } from "../texts.js";
import { chart, faint } from "./plotly.js";

const AROUND = 0.8; // m of the building shown around what was driven

/**
 * @typedef {import("../plan/floor_plan.js").Point} Point
 * @param {import("types/api").TrajectoriesView} driven
 * @param {Pick<import("../plan/floor_plan.js").FloorPlan, "walls"> | null} plan @param {AbortSignal} signal
 */
export function trajectoriesChart(driven, plan, signal) {
  return chart(t("review-trajectories"), signal, (colours) => {
    const wall = {
      mode: "lines",
      line: { color: faint(colours.text, 0.35), width: 2 },
      hoverinfo: "skip",
      showlegend: false,
    };
    /** @type {PlotlyTrace[]} */
    const traces = (plan?.walls ?? []).map((line) => ({ ...wall, ...columns(line) }));
    const newest = driven.trajectories.length - 1;
    const share = Math.max(0.4, 1 / Math.max(1, driven.trajectories.length ** 0.4));
    driven.trajectories.forEach((one, i) =>
      traces.push({
        mode: "lines",
        x: one.x,
        y: one.y,
        legendgroup: i === newest ? "newest" : "earlier",
        showlegend: i === newest || i === 0,
        line: {
          color: i === newest ? colours["path-driven"] : faint(colours["path-driven"], share * 0.8),
          width: i === newest ? 3 : 1.5,
        },
        name: t(i === newest ? "review-newest" : "review-earlier"),
        hovertemplate: `${t("review-trial-line", { number: one.number })}<extra></extra>`,
      }),
    );
    const path = columns(driven.path);
    const isOneColour = colours["path-prescribed"] === colours["path-driven"]; // in forced colours
    if (driven.path.length)
      traces.push({
        mode: "lines",
        ...path,
        line: { color: colours["path-prescribed"], width: 3, dash: isOneColour ? "dash" : "solid" },
        name: t("review-path-line"),
        hoverinfo: "skip",
      });
    const all = {
      x: [...path.x, ...driven.trajectories.flatMap(({ x }) => x)],
      y: [...path.y, ...driven.trajectories.flatMap(({ y }) => y)],
    };
    /** @param {string} words @param {number[]} values */
    const axis = (words, values) => ({
      title: { text: words },
      range: around(values),
      zeroline: false,
      showgrid: false,
    });
    return {
      traces,
      layout: { xaxis: axis("x (m)", all.x), yaxis: { ...axis("y (m)", all.y), scaleanchor: "x" } },
    };
  });
}

/** From the least to the greatest, and a little further. @param {number[]} values */
function around(values) {
  if (!values.length) return undefined;
  const least = values.reduce((a, b) => Math.min(a, b));
  const greatest = values.reduce((a, b) => Math.max(a, b));
  return [least - AROUND, greatest + AROUND];
}

/** @param {Point[]} line */
function columns(line) {
  return { x: line.map(([x]) => x), y: line.map(([, y]) => y) };
}
