/**
 * The quality of control over trials: a figure to choose, for all joints or one, and what to look at.
 * @import { QualityRow } from "types/api"
 */
import { t } from "../../texts.js";
import { controlWarnings } from "../../results/control_warnings.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { jointLabel } from "../../widgets/joint_words.js";
import { chart, faint } from "../../charts/plotly.js";
import { groupMark } from "../../results/source_group.js";
import { OF_JOINT, QUALITIES } from "../../results/quality_card.js";

/** @type {string[]} */
const OF_ALL = ["map_angle_deg", "evr", "null_space_share", "cross_talk", "activations_per_metre", "activations"];
const SHARES = new Set(["evr", "null_space_share", "cross_talk", "span_share"]);
/** @type {Record<string, string>} */
const UNITS = { map_angle_deg: "°", rest_rate: t("replay-unit-rate"), activations_per_metre: "/m" };
const ALL = "";

/**
 * @param {import("../../main.js").App} app @param {{id: number}} patient
 * @param {string} where the query that names floor plan and path @param {AbortSignal} signal
 * @returns {Promise<HTMLElement>}
 */
export async function qualitySection(app, patient, where, signal) {
  const found = await app.api.get(`/patients/${patient.id}/quality?${where}`);
  const place = h("div", {});
  const fields = h("div", { class: "columns filters" });
  let joint = ALL;
  let name = "map_angle_deg";
  let drawn = new AbortController();
  const draw = async () => {
    drawn.abort();
    const until = (drawn = new AbortController()).signal;
    signal.addEventListener("abort", () => drawn.abort(), { signal: until });
    const picture = await qualityChart(found.trials, name, joint, until);
    if (!until.aborted) put(place, picture);
  };
  const redraw = () => app.toasts.attempt(draw);
  const choose = () => {
    /** @type {readonly string[]} */
    const names = joint === ALL ? OF_ALL : OF_JOINT;
    if (!names.includes(name)) name = names[0];
    put(
      fields,
      field(
        t("quality-choose"),
        selection(
          names.map((value) => ({ value, label: t(`quality-${value}`) })),
          name,
          (value) => {
            name = value;
            redraw();
          },
        ),
      ),
      field(
        t("quality-choose-joint"),
        selection(
          [
            { value: ALL, label: t("quality-all-joints") },
            ...Object.entries(found.labels).map(([name, label]) => ({
              value: name,
              label: jointLabel({ name, label }),
            })),
          ],
          joint,
          (value) => {
            joint = value;
            choose();
            redraw();
          },
        ),
      ),
    );
  };
  if (found.trials.length) {
    choose();
    await draw();
  }
  return h(
    "div",
    { class: "stack" },
    controlWarnings(found.warnings, app.me?.role !== "reviewer"),
    h(
      "section",
      { class: "card" },
      h("h2", {}, t("quality-over"), " ", groupMark(found.source)),
      found.trials.length ? [fields, place] : h("p", { class: "quiet" }, t("quality-empty")),
      found.note && h("p", { class: "quiet small" }, found.note),
    ),
  );
}

/** @param {QualityRow[]} trials @param {string} name of the figure @param {string} joint or ALL @param {AbortSignal} signal */
function qualityChart(trials, name, joint, signal) {
  const scale = SHARES.has(name) ? 100 : 1;
  const unit = SHARES.has(name) ? "%" : (UNITS[name] ?? "");
  const title = [t(`quality-${name}`), unit && `(${unit})`].filter(Boolean).join(" ");
  const rows = trials.flatMap((trial) => {
    const value = joint === ALL ? trial.quality[name] : trial.joints[joint]?.[name];
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
