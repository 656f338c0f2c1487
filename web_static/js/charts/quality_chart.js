/**
 * A figure of the quality of control over trials; a dotted line stands where another map begins.
 * @import { QualityRow } from "types/api"
 */
import { t } from "../texts.js";
import { QUALITIES } from "../results/quality_card.js";
import { aroundNumbers, extent } from "./extent.js";
import { chart, faint } from "./plot.js";

const SHARES = new Set(["evr", "null_space_share", "cross_talk", "span_share"]);
/** @type {Record<string, string>} */
const UNITS = { map_angle_deg: "°", rest_rate: t("replay-unit-rate"), activations_per_metre: "/m" };
const MAPS = 10; // px from the frame to the middle of the words that name them

/**
 * @param {QualityRow[]} trials at least one @param {string} name of the figure @param {string} joint "" for all joints
 * @param {AbortSignal} signal
 */
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
    ].join("\n");
  const values = rows.map(({ value }) => value * scale);
  const range = extent(values, true) ?? [0, 1];
  const begun = trials
    .filter((trial, i) => i > 0 && trial.map_version !== trials[i - 1].map_version)
    .map(({ number, map_version }) => ({ x: number - 0.5, text: t("quality-map", { number: map_version }) }));
  return chart(`${t("quality-over")}: ${title}`, signal, (colours) => ({
    x: { name: t("quality-trial"), range: aroundNumbers(trials.map(({ number }) => number)), isWhole: true },
    y: { name: title, range },
    above: 2 * MAPS,
    rows: [{ above: MAPS, texts: begun, isAfter: true }],
    series: [
      ...begun.map(({ x }) => ({
        x: [x, x],
        y: range,
        line: { colour: colours.action, dash: [2, 4], width: 1.5 },
      })),
      {
        x: rows.map(({ trial }) => trial.number),
        y: values,
        line: { colour: faint(colours.text, 0.35), width: 1.5 },
        mark: { symbol: "disc", colour: colours.text },
        words: (i) => words(rows[i]),
      },
    ],
  }));
}
