/** A measure over trials with its fitted curve, the sessions behind it and the versions of the map above it. */
import { t } from "../texts.js";
import { ABOVE, mapAxis, mapTraces, sessionShapes, sessionWords } from "./curve_marks.js";
import { comparable, entryOf, inUnit, measured, nameOf } from "../results/measures.js";
import { extent } from "./extent.js";
import { chart, faint } from "./plotly.js";

/**
 * @typedef {import("types/documents").LearningTrial} LearningTrial
 * @typedef {import("./plotly.js").Colours} Colours
 */

/**
 * @param {Pick<import("types/documents").Learning, "trials">} learning @param {string} measure
 * @param {import("types/documents").CurveModel | null} fit the curve to draw with its band
 * @param {(trial: number) => void} open called with the id of a trial after a tap on it @param {AbortSignal} signal
 */
export function curveChart(learning, measure, fit, open, signal) {
  const rows = learning.trials.filter((row) => measured(row, measure) !== null);
  const { unit, better } = entryOf(measure);
  const title = [nameOf(measure), unit && `(${unit})`].filter(Boolean).join(" ");
  // The fitted band may be far wider than all that was measured: it does not count.
  const values = [
    ...rows.map((row) => (comparable(measure, row) ? inUnit(measure, measured(row, measure)) : below(rows, measure))),
    ...(fit?.value ?? []).map((value) => inUnit(measure, value)),
    ...(measure === "dist" && rows.length ? [Number(rows[rows.length - 1].path_length)] : []),
  ];
  /** @param {Colours} colours */
  const make = (colours) => {
    const last = rows.at(-1);
    const range = last ? [rows[0].number - 0.5, last.number + 0.5] : [0.5, 1.5];
    return {
      traces: [
        ...(fit ? fitTraces(fit, measure, colours) : []),
        ...(measure === "dist" && last ? [lengthTrace(rows[0], last, colours)] : []),
        ...trialTraces(rows, measure, colours),
        ...mapTraces(rows, colours),
      ],
      layout: {
        xaxis: { title: { text: t("review-trial") }, dtick: rows.length > 12 ? undefined : 1, range },
        yaxis: { title: { text: title }, range: extent(values, better === "low"), domain: [0, ABOVE] },
        yaxis2: mapAxis(),
        shapes: sessionShapes(rows, colours),
        annotations: sessionWords(rows),
        hoverdistance: 30, // px: a finger is not exact
      },
    };
  };
  return chart(`${t("review-curve")}: ${title}`, signal, make, ({ customdata }) => {
    if (typeof customdata === "number") open(customdata);
  });
}

/** @param {import("types/documents").CurveModel} fit @param {string} measure @param {Colours} colours @returns {PlotlyTrace[]} */
function fitTraces(fit, measure, colours) {
  const [value, high, low] = [fit.value, fit.high, fit.low].map((line) => line?.map((one) => inUnit(measure, one)));
  const band = { mode: "lines", line: { width: 0 }, hoverinfo: "skip", x: fit.n };
  return [
    { ...band, y: high, showlegend: false },
    { ...band, y: low, fill: "tonexty", fillcolor: faint(colours.action, 0.16), name: t("review-band") },
    {
      mode: "lines",
      x: fit.n,
      y: value,
      line: { color: colours.action, width: 3 },
      name: t("review-curve"),
      hoverinfo: "skip",
    },
  ];
}

/** @param {LearningTrial} first @param {LearningTrial} last @param {Colours} colours @returns {PlotlyTrace} */
function lengthTrace(first, last, colours) {
  const length = last.path_length;
  return {
    mode: "lines",
    x: [first.number, last.number],
    y: [length, length],
    line: { color: colours["path-prescribed"], dash: "dash", width: 1.5 },
    name: t("review-length"),
    hoverinfo: "skip",
  };
}

/**
 * The trials that can be compared, joined by a line; the others as rings.
 * @param {LearningTrial[]} rows @param {string} measure @param {Colours} colours
 */
function trialTraces(rows, measure, colours) {
  const { unit, digits } = entryOf(measure);
  /** @param {LearningTrial[]} some @param {PlotlyTrace} more @returns {PlotlyTrace} */
  const trace = (some, more) => ({
    x: some.map(({ number }) => number),
    y: some.map((row) => inUnit(measure, measured(row, measure))),
    customdata: some.map(({ id }) => id),
    hovertemplate: overPoint(`%{y:.${digits}f} ${unit}`),
    ...more,
  });
  const other = rows.filter((row) => !comparable(measure, row));
  const used = rows.filter((row) => row.familiarisation && comparable(measure, row));
  const traces = [
    trace(
      rows.filter((row) => comparable(measure, row)),
      {
        mode: "lines+markers",
        showlegend: false,
        line: { color: faint(colours.text, 0.35), width: 1.5 },
        marker: {
          color: colours.text,
          size: rows.flatMap((row) => (comparable(measure, row) ? [row.familiarisation ? 0 : 9] : [])),
        },
      },
    ),
  ];
  if (used.length) {
    const marker = { color: colours.text, size: 9, symbol: "x-thin-open", line: { width: 2 } };
    traces.push(trace(used, { mode: "markers", name: t("review-used"), marker }));
  }
  if (other.length) {
    const marker = { color: faint(colours.text, 0.5), size: 9, symbol: "circle-open" };
    const hovertemplate = overPoint(t("review-not-reached"));
    // Their value is that of a part of the path: they stand below the others, whatever it is.
    const y = other.map(() => below(rows, measure));
    traces.push(trace(other, { mode: "markers", name: t("review-not-reached"), marker, hovertemplate, y }));
  }
  return traces;
}

/** What stands over a point, as a template of plotly. @param {string} value */
function overPoint(value) {
  return `${t("review-trial-point", { number: "%{x}", value })}<extra></extra>`;
}

/** Where the trials stand that cannot be compared: at 0, or at the lowest of the others. @param {LearningTrial[]} rows @param {string} measure */
function below(rows, measure) {
  const values = rows.flatMap((row) => (comparable(measure, row) ? inUnit(measure, measured(row, measure)) : []));
  return entryOf(measure).better === "low" || !values.length ? 0 : Math.min(...values);
}
