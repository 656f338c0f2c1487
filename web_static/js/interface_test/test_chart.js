/** A measure of the two-minute test over a patient's tests, with its fitted curve where there is one. */
import { t } from "../texts.js";
import { testEntry, testFigure, testMeasure } from "./test_measures.js";
import { fitSeries } from "../charts/curve_chart.js";
import { aroundNumbers, extent } from "../charts/extent.js";
import { chart, faint } from "../charts/plot.js";

/** @typedef {import("types/api").InterfaceTestsView} InterfaceTestsView */

/** @param {InterfaceTestsView} read @param {string} measure @param {AbortSignal} signal */
export function testChart({ tests, course }, measure, signal) {
  const { name, unit, better, factor } = testEntry(measure);
  const counted = new Set(course.counted);
  const rows = tests.flatMap((test) => {
    const value = testMeasure(test, measure);
    return counted.has(test.number) && value !== null ? [{ test, value }] : [];
  });
  const fit = course.curves[measure];
  const title = [name, unit && `(${unit})`].filter(Boolean).join(" ");
  const numbers = rows.map(({ test }) => test.number);
  const values = rows.map(({ value }) => value);
  /** @param {number} value */
  const scaled = (value) => value * factor;
  return chart(`${t("test-curve")}: ${title}`, signal, (colours) => ({
    x: { name: t("test-number"), range: aroundNumbers(numbers), isWhole: true },
    y: { name: title, range: extent([...values, ...(fit?.value ?? []).map(scaled)], better === "low") },
    series: [
      ...(fit ? fitSeries(fit, scaled, colours) : []),
      {
        x: numbers,
        y: values,
        line: { colour: faint(colours.text, 0.35), width: 1.5 },
        mark: { symbol: "disc", colour: colours.text },
        words: (i) => `${t("test-session", { number: rows[i].test.session })}: ${testFigure(rows[i].test, measure)}`,
      },
    ],
  }));
}
