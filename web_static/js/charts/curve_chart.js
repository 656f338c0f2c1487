/** A measure over trials with its fitted curve, the sessions behind it and the versions of the map above it. */
import { t } from "../texts.js";
import { ABOVE, mapSeries, sessionBands, sessionRow, versionRow } from "./curve_marks.js";
import { comparable, entryOf, inUnit, measured, nameOf, withUnit } from "../results/measures.js";
import { aroundNumbers, extent } from "./extent.js";
import { chart, faint } from "./plot.js";

/**
 * @typedef {import("types/documents").CurveModel} CurveModel
 * @typedef {import("types/documents").LearningTrial} LearningTrial
 * @typedef {import("./plot.js").Colours} Colours
 * @typedef {import("./plot.js").Series} Series
 */

/**
 * @param {Pick<import("types/documents").Learning, "trials">} learning @param {string} measure
 * @param {CurveModel | null} fit the curve to draw with its band
 * @param {(trial: number) => void} open called with the id of a trial after a tap on it @param {AbortSignal} signal
 */
export function curveChart(learning, measure, fit, open, signal) {
  const rows = learning.trials.filter((row) => measured(row, measure) !== null);
  const { unit, better } = entryOf(measure);
  const title = [nameOf(measure), unit && `(${unit})`].filter(Boolean).join(" ");
  const length = measure === "dist" ? rows.slice(-1).map((row) => Number(row.path_length)) : [];
  // The fitted band may be far wider than all that was measured: it does not count.
  const values = [
    ...rows.map((row) => (comparable(measure, row) ? inUnit(measure, measured(row, measure)) : below(rows, measure))),
    ...(fit?.value ?? []).map((value) => inUnit(measure, value)),
    ...length,
  ];
  const numbers = rows.map(({ number }) => number);
  return chart(
    `${t("review-curve")}: ${title}`,
    signal,
    (colours) => ({
      x: { name: t("review-trial"), range: aroundNumbers(numbers), isWhole: true },
      y: { name: title, range: extent(values, better === "low") },
      above: ABOVE,
      bands: sessionBands(rows),
      rows: [sessionRow(rows), versionRow(rows)],
      series: [
        ...(fit ? fitSeries(fit, (value) => inUnit(measure, value), colours, t("review-curve")) : []),
        ...length.map((metres) => lengthSeries(numbers, metres, colours)),
        ...trialSeries(rows, measure, colours),
        ...mapSeries(rows, colours["path-prescribed"]),
      ],
    }),
    open,
  );
}

/**
 * A fitted curve in its band.
 * @param {Pick<CurveModel, "n" | "value" | "low" | "high">} fit
 * @param {(value: number) => number} scaled gives a value in the unit of the axis
 * @param {Colours} colours @param {string} [name] in the legend @returns {Series[]}
 */
export function fitSeries({ n = [], value = [], low = [], high = [] }, scaled, colours, name) {
  const edge = [...high, ...low.toReversed()].map(scaled);
  return [
    { name: t("review-band"), x: [...n, ...n.toReversed()], y: edge, fill: faint(colours.action, 0.16) },
    { name, x: n, y: value.map(scaled), line: { colour: colours.action, width: 3 } },
  ];
}

/** @param {number[]} numbers of the trials @param {number} length m @param {Colours} colours @returns {Series} */
function lengthSeries(numbers, length, colours) {
  return {
    name: t("review-length"),
    x: [numbers[0], numbers[numbers.length - 1]],
    y: [length, length],
    line: { colour: colours["path-prescribed"], dash: [8, 6], width: 1.5 },
  };
}

/**
 * The trials that can be compared, joined by a line; the others as rings.
 * @param {LearningTrial[]} rows @param {string} measure @param {Colours} colours @returns {Series[]}
 */
function trialSeries(rows, measure, colours) {
  const [compared, others] = [true, false].map((is) => rows.filter((row) => comparable(measure, row) === is));
  /** @param {LearningTrial[]} some */
  const points = (some) => ({
    x: some.map(({ number }) => number),
    y: some.map((row) => inUnit(measure, measured(row, measure))),
    ids: some.map(({ id }) => id),
    /** @param {number} i */
    words: (i) =>
      t("review-trial-point", { number: some[i].number, value: withUnit(measure, measured(some[i], measure)) }),
  });
  const used = compared.filter(({ familiarisation }) => familiarisation);
  const notReached = t("review-not-reached");
  return [
    { ...points(compared), words: undefined, line: { colour: faint(colours.text, 0.35), width: 1.5 } },
    { ...points(compared.filter((row) => !used.includes(row))), mark: { symbol: "disc", colour: colours.text } },
    {
      ...points(used),
      name: used.length ? t("review-used") : undefined,
      mark: { symbol: "cross", colour: colours.text },
    },
    {
      ...points(others),
      name: others.length ? notReached : undefined,
      mark: { symbol: "ring", colour: faint(colours.text, 0.5) },
      // Their value is that of a part of the path: they stand below the others, whatever it is.
      y: others.map(() => below(rows, measure)),
      words: (i) => t("review-trial-point", { number: others[i].number, value: notReached }),
    },
  ];
}

/**
 * Where the trials stand that cannot be compared: at 0, or at the lowest of the others.
 * @param {LearningTrial[]} rows @param {string} measure
 */
function below(rows, measure) {
  const values = rows.flatMap((row) => (comparable(measure, row) ? inUnit(measure, measured(row, measure)) : []));
  return entryOf(measure).better === "low" || !values.length ? 0 : Math.min(...values);
}
