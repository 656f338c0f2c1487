/** A measure of the two-minute test over a patient's tests, with its fitted curve where there is one. */
import { t } from "../texts.js";
import { testEntry, testMeasure } from "./test_measures.js";
import { extent } from "../charts/extent.js";
import { chart, faint } from "../charts/plotly.js";

/** @typedef {import("types/api").InterfaceTestsView} InterfaceTestsView */

/** @param {InterfaceTestsView} read @param {string} measure @param {AbortSignal} signal */
export function testChart({ tests, course }, measure, signal) {
  const { name, unit, digits, better, factor } = testEntry(measure);
  const counted = new Set(course.counted);
  const rows = tests.flatMap((test) => {
    const value = testMeasure(test, measure);
    return counted.has(test.number) && value !== null ? [{ test, value }] : [];
  });
  const fit = course.curves[measure];
  const title = [name, unit && `(${unit})`].filter(Boolean).join(" ");
  const band = { mode: "lines", line: { width: 0 }, hoverinfo: "skip", x: fit?.n };
  /** @param {number[]} values */
  const scaled = (values) => values.map((value) => value * factor);
  return chart(`${t("test-curve")}: ${title}`, signal, (colours) => ({
    traces: [
      ...(fit
        ? [
            { ...band, y: scaled(fit.high), showlegend: false },
            {
              ...band,
              y: scaled(fit.low),
              fill: "tonexty",
              fillcolor: faint(colours.action, 0.16),
              name: t("review-band"),
            },
            {
              mode: "lines",
              x: fit.n,
              y: scaled(fit.value),
              line: { color: colours.action, width: 3 },
              showlegend: false,
              hoverinfo: "skip",
            },
          ]
        : []),
      {
        mode: "lines+markers",
        x: rows.map(({ test }) => test.number),
        y: rows.map(({ value }) => value),
        text: rows.map(({ test }) => t("test-session", { number: test.session })),
        hovertemplate: `%{text}: %{y:.${digits}f} ${unit}<extra></extra>`,
        line: { color: faint(colours.text, 0.35), width: 1.5 },
        marker: { color: colours.text, size: 9 },
        showlegend: false,
      },
    ],
    layout: {
      xaxis: {
        title: { text: t("test-number") },
        dtick: rows.length > 12 ? undefined : 1,
        range: rangeOf(rows.map(({ test }) => test.number)),
      },
      yaxis: {
        title: { text: title },
        range: extent([...rows.map(({ value }) => value), ...scaled(fit?.value ?? [])], better === "low"),
      },
      hoverdistance: 30,
    },
  }));
}

/** @param {number[]} numbers rising */
function rangeOf(numbers) {
  return numbers.length ? [numbers[0] - 0.5, numbers[numbers.length - 1] + 0.5] : [0.5, 1.5];
}
