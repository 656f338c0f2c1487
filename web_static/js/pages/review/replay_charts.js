/**
 * All charts of a trial's time line: chair, commands, activations, rates, scores, and the signals of one joint.
 * @import { GestureLine, Timeline } from "types/api"
 * @import { PlayHead } from "./play_head.js"
 * @typedef {{title: string, unit: string, lines: {name: string, values: (number | null)[]}[], range?: [number, number],
 *   digits?: number, height?: number}} Chart what one chart shows
 */
import { timeChart } from "../../charts/time_chart.js";
import { h, useMemo, useSignal } from "../../preact.js";
import { palette } from "../../shell/theme.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { gestureWords } from "../../widgets/gestures.js";
import { labelsOf, sensorName } from "../../widgets/joint_words.js";
import { Made } from "../../widgets/made.js";

const DEGREES = 180 / Math.PI;
const COLOURS = /** @type {const} */ (["action", "path-driven", "path-prescribed", "good", "attention", "bad"]);

/** @param {{line: Timeline, head: PlayHead, left: AbortSignal}} charts line: what GET /trials/ID/timeline answered */
export function ReplayCharts({ line, head, left }) {
  const joints = line.joints.filter(({ channels }) => channels.length);
  const labels = labelsOf(line.joints);
  const chosen = useSignal(joints[0]?.name);
  const fixed = useMemo(() => fixedCharts(line), []);
  const joint = joints.find(({ name }) => name === chosen.value);
  return h(
    "section",
    { class: "card replay-charts" },
    h("h2", {}, t("replay-charts")),
    h("p", { class: "quiet small" }, t("replay-charts-lead")),
    fixed.map((chart) => h(TimeChart, { key: chart.title, chart, line, head, left })),
    joint &&
      h(
        Field,
        { label: t("replay-joint") },
        h(Selection, {
          options: joints.map(({ name }) => ({ value: name, label: labels[name] })),
          chosen: joint.name,
          onChange: (name) => void (chosen.value = name),
        }),
      ),
    joint && h(TimeChart, { key: joint.name, chart: signalsOf(joint), line, head, left }),
  );
}

/** A chart as it is at first. @param {{chart: Chart, line: Timeline, head: PlayHead, left: AbortSignal}} place */
function TimeChart({ chart, line, head, left }) {
  /** @param {AbortSignal} gone */
  const make = (gone) => {
    const { colours, stop } = palette("border", "text-quiet", ...COLOURS);
    const lines = chart.lines.map((one, i) => ({ colour: COLOURS[i % COLOURS.length], ...one }));
    const { element, draw, show } = timeChart({ ...chart, lines, times: line.t, state: line.state }, head, colours);
    const size = new ResizeObserver(draw);
    size.observe(element);
    document.addEventListener("themechange", draw, { signal: gone });
    head.follow(show, gone);
    gone.addEventListener("abort", () => {
      size.disconnect();
      stop();
    });
    return element;
  };
  return h(Made, { left, make });
}

/** The charts that every trial has. @param {Timeline} line @returns {Chart[]} */
function fixedCharts({ v, omega, u1, u2, gestures, joints }) {
  const labels = labelsOf(joints);
  /** @param {"activation" | "rate" | "score"} column */
  const linesOf = (column) => gestures.map((one) => ({ name: gestureWords(one, labels), values: one[column] }));
  const degrees = omega.map((value) => (value === null ? null : value * DEGREES));
  const [speed, turning] = [t("replay-command-speed"), t("replay-command-turning")];
  const [full, share] = [t("replay-unit-full"), t("replay-unit-share")];
  /** @type {Chart[]} */
  const ofGestures = [
    { title: t("replay-activations"), unit: full, lines: linesOf("activation"), range: [0, 1] },
    { title: t("replay-rates"), unit: rateUnit(gestures), lines: linesOf("rate") },
    { title: t("replay-scores"), unit: share, lines: linesOf("score") },
  ];
  return [
    {
      title: t("replay-chair"),
      unit: "m/s · °/s",
      lines: [
        { name: t("replay-v"), values: v },
        { name: t("replay-omega"), values: degrees },
      ],
    },
    {
      title: t("replay-commands"),
      unit: full,
      lines: [
        { name: speed, values: u1 },
        { name: turning, values: u2 },
      ],
      range: [-1, 1],
    },
    ...(gestures.length ? ofGestures : []),
  ];
}

/** The signals of a joint. @param {Timeline["joints"][number]} joint @returns {Chart} */
function signalsOf({ channels, of }) {
  const lines = channels.map(({ name, values }) => ({ name: sensorName(name), values }));
  return { title: t("replay-signals", { shown: lines.length, of }), unit: "", lines, digits: 3, height: 120 };
}

/** @param {GestureLine[]} gestures */
function rateUnit(gestures) {
  return gestures.every(({ feature }) => feature === "rate")
    ? t("replay-unit-rate")
    : `${t("replay-unit-rate")} · ${t("replay-unit-share")}`;
}
