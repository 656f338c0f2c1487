/** The two charts of the paper: a measure over trials with its fitted curve, and all trajectories over the path. */
import { t } from "../texts.js";
import { comparable, MEASURES } from "./measures.js";
import { chart, faint } from "./plotly.js";

const AROUND = 1.5; // m of the building shown around what was driven

/** @param {any} learning what GET /patients/ID/learning answered @param {string} measure @param {AbortSignal} signal */
export function curveChart(learning, measure, signal) {
  const { unit } = MEASURES[measure];
  const rows = learning.trials.filter((row) => Number.isFinite(row[measure]));
  const fit = learning.curves[measure]?.fit;
  const title = [t(`measure.${measure}`), unit && `(${unit})`].filter(Boolean).join(" ");
  return chart(`${t("review.curve")}: ${title}`, signal, (colours) => {
    const traces = [];
    if (fit) {
      const band = { mode: "lines", line: { width: 0 }, hoverinfo: "skip" };
      traces.push(
        { ...band, x: fit.n, y: fit.high, showlegend: false },
        {
          ...band,
          x: fit.n,
          y: fit.low,
          fill: "tonexty",
          fillcolor: faint(colours.action, 0.16),
          name: t("review.band"),
        },
        {
          mode: "lines",
          x: fit.n,
          y: fit.value,
          line: { color: colours.action, width: 3 },
          name: t("review.fit"),
          hoverinfo: "skip",
        },
      );
    }
    if (measure === "dist" && rows.length) {
      const length = rows.at(-1).path_length;
      traces.push({
        mode: "lines",
        x: [rows[0].number, rows.at(-1).number],
        y: [length, length],
        line: { color: colours["path-prescribed"], dash: "dash", width: 1.5 },
        name: t("review.length"),
        hoverinfo: "skip",
      });
    }
    traces.push(...trialTraces(rows, measure, colours));
    const range = rows.length ? [rows[0].number - 0.5, rows.at(-1).number + 0.5] : [0.5, 1.5];
    return {
      traces,
      layout: {
        xaxis: { title: { text: t("review.trial") }, dtick: rows.length > 12 ? undefined : 1, range },
        yaxis: { title: { text: title }, rangemode: MEASURES[measure].better === "low" ? "tozero" : "normal" },
      },
    };
  });
}

/** The trials that can be compared, joined by a line; the others as rings beside it. */
function trialTraces(rows, measure, colours) {
  const { unit, digits } = MEASURES[measure];
  const trace = (some, more) => ({
    x: some.map(({ number }) => number),
    y: some.map((row) => row[measure]),
    hovertemplate: `${t("review.trial")} %{x}: %{y:.${digits}f} ${unit}<extra></extra>`,
    ...more,
  });
  const other = rows.filter((row) => !comparable(measure, row));
  const traces = [
    trace(
      rows.filter((row) => comparable(measure, row)),
      {
        mode: "lines+markers",
        showlegend: false,
        line: { color: faint(colours.text, 0.35), width: 1.5 },
        marker: { color: colours.text, size: 9 },
      },
    ),
  ];
  if (other.length) {
    const marker = { color: faint(colours.text, 0.5), size: 9, symbol: "circle-open" };
    traces.push(trace(other, { mode: "markers", name: t("review.not-reached"), marker }));
  }
  return traces;
}

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
