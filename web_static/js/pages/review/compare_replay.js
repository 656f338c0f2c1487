/**
 * Two trials on one plan, both replayed from when motion was permitted; and speed and error along the path.
 * @import { FloorPlan, Timeline, TrialDetail } from "types/api"
 */
import { t } from "../../texts.js";
import { h, write } from "../../widgets/dom.js";
import { number } from "../../widgets/format.js";
import { planPicture } from "../../plan/plan_svg.js";
import { playBar, playKeys } from "./play_bar.js";
import { PlayHead } from "./play_head.js";
import { alongChart, COLOURS } from "../../charts/along_chart.js";
import { poseAt, trajectoryOf } from "../../plan/replay_plan.js";

/**
 * @param {HTMLElement} root of the page @param {TrialDetail[]} trials two, as GET /trials/ID answered
 * @param {Timeline[]} lines their time lines @param {FloorPlan | null} plan @param {AbortSignal} signal
 */
export async function compareReplay(root, trials, lines, plan, signal) {
  const head = new PlayHead(0, Math.max(...lines.map(endOf)), signal);
  const [lastTrial, lastLine] = [trials[trials.length - 1], lines[lines.length - 1]];
  const where = lastLine.floorplan ?? plan;
  const hasPath = lines.every(({ along }) => along.length);
  const now = trials.map(() => h("span", { class: "number" }));
  const shown = where && bothOnOne(where, lastTrial, lines);
  const show = () => {
    lines.forEach((line, i) => {
      const at = poseAt(line, Math.min(head.t, endOf(line)));
      shown?.setPose[i](at.pose);
      write(now[i], momentWords(line, at.place));
    });
  };
  head.addEventListener("time", show, { signal });
  show();
  const charts = hasPath
    ? await Promise.all([
        alongChart(trials, lines, "v", t("compare-speed"), t("compare-speed-axis"), signal),
        alongChart(trials, lines, "across", t("compare-across"), t("compare-across-axis"), signal),
      ])
    : [];
  const titles = [t("compare-speed"), t("compare-across")];
  const element = h(
    "section",
    { class: "replay" },
    h(
      "section",
      { class: "card compare-plan" },
      h("h2", {}, t("compare-plan")),
      shown?.element,
      h(
        "ul",
        { class: "compare-now" },
        trials.map((trial, i) =>
          h("li", {}, swatch(i), h("b", {}, t("compare-trial", { number: trial.number })), " ", now[i]),
        ),
      ),
      h("p", { class: "quiet small" }, t("compare-start")),
    ),
    playBar(head, [], signal),
    h("p", { class: "quiet small" }, t("replay-keys")),
    h(
      "div",
      { class: "charts" },
      charts.map((one, i) => h("section", { class: "card" }, h("h2", {}, titles[i]), one)),
    ),
  );
  playKeys(root, head, signal);
  return element;
}

/** When a time line ends, s. @param {Timeline} line */
function endOf(line) {
  return Number(line.t.at(-1));
}

/** @param {FloorPlan} plan @param {TrialDetail} trial @param {Timeline[]} lines */
function bothOnOne(plan, trial, lines) {
  const request = plan.paths.find(({ name }) => name === trial.path_name) ?? null;
  const picture = planPicture(plan, trial.path, { label: t("compare-plan"), hasRooms: true, request });
  const second = picture.another();
  picture.setTrajectory(trajectoryOf(lines[0]));
  second.setTrajectory(trajectoryOf(lines[1]));
  return { element: picture.element, setPose: [picture.setPose, second.setPose] };
}

/** @param {Timeline} line @param {number} place in it */
function momentWords(line, place) {
  const v = number(line.v[place], 2);
  if (!line.along.length) return t("compare-now-spot", { v });
  return t("compare-now", { along: number(line.along[place], 1), across: number(line.across[place], 2), v });
}

/** @param {number} i of the trial */
function swatch(i) {
  return h("i", { class: "swatch", style: `border-top: 4px ${i ? "dashed" : "solid"} var(--${COLOURS[i]})` });
}
