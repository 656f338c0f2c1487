/**
 * A figure of the quality of control over trials; a dotted line stands where another map begins.
 * @import { QualityRow } from "types/api"
 */
import { t } from "../texts.js";
import { QUALITIES } from "../results/quality_card.js";
import { chart, faint } from "./plotly.js";

const SHARES = new Set(["evr", "null_space_share", "cross_talk", "span_share"]);
/** @type {Record<string, string>} */
const UNITS = { map_angle_deg: "°", rest_rate: t("replay-unit-rate"), activations_per_metre: "/m" };

/** @param {QualityRow[]} trials @param {string} name of the figure @param {string} joint "" for all @param {AbortSignal} signal */
export function qualityChart(trials, name, joint, signal) {
  const scale = SHARES.has(name) ? 100 : 1;
  const unit = SHARES.has(name) ? "%" : (UNITS[name] ?? "");
  const title = [t(`quality-${name}`), unit && `(${unit})`].filter(Boolean).join(" ");
  const rows = trials.flatMap((trial) => {
    const value = joint ? trial.joints[joint]?.[name] : trial.quality[name];
    return typeof value === "number" && Number.isFinite(value) ? [{ trial, value }] : [];
  });
  /** @param {typeof rows[number]} row */
  const words = ({ trial, value }) =>
    [
      t("review-trial-point", { number: trial.number, value: QUALITIES[name](value) }),
      t("quality-session", { number: trial.session }),
      t("quality-map", { number: trial.map_version }),
    ].join("<br>");
  const breaks = trials.filter((trial, i) => i > 0 && trial.map_version !== trials[i - 1].map_version);
  return chart(`${t("quality-over")}: ${title}`, signal, (colours) => ({
    traces: [
      {
        mode: "lines+markers",
        showlegend: false,
        x: rows.map(({ trial }) => trial.number),
        y: rows.map(({ value }) => value * scale),
        text: rows.map(words),
        hovertemplate: "%{text}<extra></extra>",
        line: { color: faint(colours.text, 0.35), width: 1.5 },
        marker: { color: colours.text, size: 9 },
      },
    ],
    layout: {
      xaxis: {
        title: { text: t("quality-trial") },
        dtick: trials.length > 12 ? undefined : 1,
        range: [trials[0].number - 0.5, trials[trials.length - 1].number + 0.5],
      },
      yaxis: { title: { text: title }, rangemode: "tozero" },
      shapes: breaks.map(({ number }) => ({
        type: "line",
        xref: "x",
        yref: "paper",
        x0: number - 0.5,
        x1: number - 0.5,
        y0: 0,
        y1: 1,
        line: { color: colours.action, dash: "dot", width: 1.5 },
      })),
      annotations: breaks.map(({ number, map_version }) => ({
        xref: "x",
        yref: "paper",
        x: number - 0.5,
        y: 1,
        xanchor: "left",
        yanchor: "top",
        showarrow: false,
        text: t("quality-map", { number: map_version }),
        font: { color: colours["text-quiet"] },
      })),
    },
  }));
}
