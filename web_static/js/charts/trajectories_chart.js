/** All trajectories over the path: the paper's figure. */
import { t } from "../texts.js";
import { chart, faint } from "./plotly.js";

const AROUND = 1.5; // m of the building shown around what was driven

/** @param {any} learning @param {any} plan or null @param {AbortSignal} signal */
export function trajectoriesChart(learning, plan, signal) {
  return chart(t("review.trajectories"), signal, (colours) => {
    const wall = {
      mode: "lines",
      line: { color: faint(colours.text, 0.35), width: 2 },
      hoverinfo: "skip",
      showlegend: false,
    };
    const traces = (plan?.walls ?? []).map((line) => ({ ...wall, ...columns(line) }));
    const newest = learning.trajectories.length - 1;
    const share = Math.max(0.4, 1 / Math.max(1, learning.trajectories.length ** 0.4));
    learning.trajectories.forEach((one, i) =>
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
        name: t(i === newest ? "review.newest" : "review.earlier"),
        hovertemplate: `${t("review.trial")} ${one.number}<extra></extra>`,
      }),
    );
    if (learning.path.length)
      traces.push({
        mode: "lines",
        ...columns(learning.path),
        line: { color: colours["path-prescribed"], width: 3 },
        name: t("review.path.line"),
        hoverinfo: "skip",
      });
    const driven = learning.trajectories.flatMap(({ x, y }) => x.map((each, i) => [each, y[i]]));
    const shown = columns([...learning.path, ...driven]);
    const axis = (words, values) => ({
      title: { text: words },
      range: around(values),
      zeroline: false,
      showgrid: false,
    });
    return {
      traces,
      layout: { xaxis: axis("x (m)", shown.x), yaxis: { ...axis("y (m)", shown.y), scaleanchor: "x" } },
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

function columns(line) {
  return { x: line.map(([x]) => x), y: line.map(([, y]) => y) };
}
