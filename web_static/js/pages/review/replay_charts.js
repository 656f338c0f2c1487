/**
 * All charts of a trial's time line: chair, commands, activations, rates, scores, and the signals of one joint.
 * @import { GestureLine, Timeline } from "types/api"
 */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { gestureWords } from "../../widgets/gestures.js";
import { labelsOf, sensorName } from "../../widgets/joint_words.js";
import { palette } from "../../shell/theme.js";
import { timeChart } from "../../charts/time_chart.js";

const DEGREES = 180 / Math.PI;
const COLOURS = /** @type {const} */ (["action", "path-driven", "path-prescribed", "good", "attention", "bad"]);

/**
 * @param {Timeline} line what GET /trials/ID/timeline answered @param {import("./play_head.js").PlayHead} head
 * @param {AbortSignal} signal
 */
export function replayCharts(line, head, signal) {
  const { colours, stop } = palette("border", "text-quiet", ...COLOURS);
  const common = { times: line.t, state: line.state };
  /**
   * @param {string} title @param {string} unit @param {{name: string, values: (number | null)[]}[]} lines
   * @param {{range?: [number, number], digits?: number, height?: number}} [more]
   */
  const make = (title, unit, lines, more = {}) =>
    timeChart(
      {
        ...common,
        title,
        unit,
        lines: lines.map((one, i) => ({ colour: COLOURS[i % COLOURS.length], ...one })),
        ...more,
      },
      head,
      colours,
    );
  const labels = labelsOf(line.joints);
  /** @param {"activation" | "rate" | "score"} column */
  const gestures = (column) => line.gestures.map((one) => ({ name: gestureWords(one, labels), values: one[column] }));
  const fixed = [
    make(t("replay-chair"), "m/s · °/s", [
      { name: t("replay-v"), values: line.v },
      { name: t("replay-omega"), values: line.omega.map((omega) => (omega === null ? null : omega * DEGREES)) },
    ]),
    make(
      t("replay-commands"),
      t("replay-unit-full"),
      [
        { name: t("replay-command-speed"), values: line.u1 },
        { name: t("replay-command-turning"), values: line.u2 },
      ],
      { range: [-1, 1] },
    ),
  ];
  if (line.gestures.length)
    fixed.push(
      make(t("replay-activations"), t("replay-unit-full"), gestures("activation"), { range: [0, 1] }),
      make(t("replay-rates"), rateUnit(line.gestures), gestures("rate")),
      make(t("replay-scores"), t("replay-unit-share"), gestures("score")),
    );
  /** @type {ReturnType<typeof timeChart> | null} */
  let signals = null;
  const place = h("div", {});
  const joints = line.joints.filter(({ channels }) => channels.length);
  /** @param {string} name */
  const chooseJoint = (name) => {
    const joint = joints.find((one) => one.name === name) ?? joints[0];
    const lines = joint.channels.map((channel) => ({ name: sensorName(channel.name), values: channel.values }));
    signals = make(t("replay-signals", { shown: lines.length, of: joint.of }), "", lines, { digits: 3, height: 120 });
    put(place, signals.element);
    signals.draw();
  };
  const all = () => (signals ? [...fixed, signals] : fixed);
  const draw = () => all().forEach((chart) => chart.draw());
  const element = h(
    "section",
    { class: "card replay-charts" },
    h("h2", {}, t("replay-charts")),
    h("p", { class: "quiet small" }, t("replay-charts-lead")),
    fixed.map((chart) => chart.element),
    joints.length > 0 &&
      field(
        t("replay-joint"),
        selection(
          joints.map(({ name }) => ({ value: name, label: labels[name] })),
          joints[0].name,
          chooseJoint,
        ),
      ),
    place,
  );
  if (joints.length) chooseJoint(joints[0].name);
  const size = new ResizeObserver(draw);
  size.observe(element);
  document.addEventListener("themechange", draw);
  head.addEventListener("time", () => all().forEach((chart) => chart.show()), { signal });
  signal.addEventListener("abort", () => {
    size.disconnect();
    document.removeEventListener("themechange", draw);
    stop();
  });
  return element;
}

/** @param {GestureLine[]} gestures */
function rateUnit(gestures) {
  return gestures.every(({ feature }) => feature === "rate")
    ? t("replay-unit-rate")
    : `${t("replay-unit-rate")} · ${t("replay-unit-share")}`;
}
