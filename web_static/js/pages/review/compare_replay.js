/**
 * Two trials on one plan, both replayed from when motion was permitted; and speed and error along the path.
 * @import { FloorPlan, Timeline, TrialDetail } from "types/api"
 * @import { PlayHead } from "./play_head.js"
 */
import { alongChart, COLOURS } from "../../charts/along_chart.js";
import { ChartPlace } from "../../charts/chart_place.js";
import { planPicture } from "../../plan/plan_svg.js";
import { poseAt, trajectoryOf } from "../../plan/replay_plan.js";
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { number } from "../../widgets/format.js";
import { Made } from "../../widgets/made.js";
import { PlayBar } from "./play_bar.js";
import { placeOf } from "./play_head.js";

/**
 * @param {object} replay
 * @param {import("../../main.js").App} replay.app @param {AbortSignal} replay.left
 * @param {TrialDetail[]} replay.trials two, as GET /trials/ID answered
 * @param {Timeline[]} replay.lines the time lines of the trials
 * @param {FloorPlan | null} replay.plan null where the place is not known @param {PlayHead} replay.head
 */
export function CompareReplay({ app, left, trials, lines, plan, head }) {
  /** @param {"v" | "across"} column @param {string} title @param {string} axis */
  const chart = (column, title, axis) =>
    h(
      "section",
      { class: "card" },
      h("h2", {}, title),
      h(ChartPlace, {
        app,
        left,
        of: [],
        make: (until) => alongChart(trials, lines, column, title, axis, until),
      }),
    );
  const hasPath = lines.every(({ along }) => along.length);
  return h(
    "section",
    { class: "replay" },
    h(
      "section",
      { class: "card compare-plan" },
      h("h2", {}, t("compare-plan")),
      plan && h(Made, { left, make: (gone) => bothOnOne(plan, trials[1], lines, head, gone) }),
      h(
        "ul",
        { class: "compare-now" },
        trials.map((trial, i) =>
          h(
            "li",
            { key: i },
            h("i", { class: "swatch", style: `border-top: 4px ${i ? "dashed" : "solid"} var(--${COLOURS[i]})` }),
            h("b", {}, t("compare-trial", { number: trial.number })),
            " ",
            h(Now, { line: lines[i], head }),
          ),
        ),
      ),
      h("p", { class: "quiet small" }, t("compare-start")),
    ),
    h(PlayBar, { head }),
    h("p", { class: "quiet small" }, t("replay-keys")),
    h(
      "div",
      { class: "charts" },
      hasPath && chart("v", t("compare-speed"), t("compare-speed-axis")),
      hasPath && chart("across", t("compare-across"), t("compare-across-axis")),
    ),
  );
}

/**
 * The plan with both trials on it.
 * @param {FloorPlan} plan @param {TrialDetail} trial @param {Timeline[]} lines @param {PlayHead} head
 * @param {AbortSignal} gone
 */
function bothOnOne(plan, trial, lines, head, gone) {
  const request = plan.paths.find(({ name }) => name === trial.path_name) ?? null;
  const picture = planPicture(plan, trial.path, { label: t("compare-plan"), hasRooms: true, request });
  [picture, picture.another()].forEach(({ setTrajectory, setPose }, i) => {
    setTrajectory(trajectoryOf(lines[i]));
    head.follow((now) => setPose(poseAt(lines[i], now).pose), gone);
  });
  return picture.element;
}

/**
 * Where the chair of one trial is at the moment that is shown; after the end of the trial, where it ended.
 * @param {{line: Timeline, head: PlayHead}} now
 */
function Now({ line, head }) {
  const place = placeOf(line.t, head.t);
  const v = number(line.v[place], 2);
  const [along, across] = [number(line.along[place], 1), number(line.across[place], 2)];
  return h(
    "span",
    { class: "number" },
    line.along.length ? t("compare-now", { along, across, v }) : t("compare-now-spot", { v }),
  );
}
