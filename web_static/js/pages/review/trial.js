/**
 * One trial of Review: its replay, where one slider moves picture, plan and charts together, and what it came to.
 * @import { App } from "../../main.js"
 * @import { FloorPlan, Timeline, TrialDetail } from "types/api"
 * @import { CommentStore } from "./comments_card.js"
 */
import { failureWords } from "../../api.js";
import { onNews } from "../../live/news.js";
import { replayPlan } from "../../plan/replay_plan.js";
import { h } from "../../preact.js";
import { readTrial, showTrialOver } from "../../results/trial_over.js";
import { emptyPage } from "../../shell/nobody.js";
import { t } from "../../texts.js";
import { Made } from "../../widgets/made.js";
import { CommentMarks, CommentsCard, commentStore } from "./comments_card.js";
import { EventList, PlayBar, playKeys } from "./play_bar.js";
import { PlayHead } from "./play_head.js";
import { ReplayCharts } from "./replay_charts.js";
import { ReplayView } from "./replay_view.js";

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest: [patient, , id] }) {
  const read = await readTrial(app.api, id);
  if (left.aborted) return;
  const { trial } = read;
  app.setSubject({ patient: trial.patient_id, code: trial.patient_code, sessions: [trial.session_number] });
  if (trial.status === "running") {
    const lookWhetherOver = async () => {
      const now = await app.api.get(`/trials/${id}`).catch(() => null);
      if (!left.aborted && now && now.status !== "running") app.show();
    };
    onNews(app, left, { what: ["trial"], trial: trial.id }, lookWhetherOver);
    const title = t("review-running-title", { number: trial.number });
    return emptyPage(root, title, t("review-running-lead"), `#/review/${patient}`, t("review-back"));
  }
  let why = "";
  const [line, comments] = await Promise.all([
    app.api.get(`/trials/${id}/timeline`).catch((error) => void (why = failureWords(error))),
    app.api.get(`/trials/${id}/comments`),
  ]);
  if (left.aborted) return;
  const store = commentStore(app, trial.id, comments, left);
  const actions = () => h("a", { class: "btn", href: `#/review/${patient}` }, t("review-back"));
  if (!line) return showTrialOver(app, root, read, { left, actions, above: h(WithoutReplay, { why, store }) });
  const head = new PlayHead(Number(line.t[0]), Number(line.t.at(-1)), left);
  const plan = line.floorplan ?? read.plan;
  const above = h(Replay, { app, left, trial, plan, line, head, store });
  showTrialOver(app, root, read, { left, actions, above });
  playKeys(root, head, left);
}

/** Why there is no replay, and the comments, when there are some. @param {{why: string, store: CommentStore}} page */
function WithoutReplay({ why, store }) {
  return h(
    "div",
    { class: "replay" },
    h("p", { class: "card quiet" }, t("replay-none"), " ", why),
    store.comments.value.length > 0 && h(CommentsCard, { store, head: null }),
  );
}

/**
 * @param {{app: App, left: AbortSignal, trial: TrialDetail, plan: FloorPlan | null, line: Timeline, head: PlayHead,
 *   store: CommentStore}} replay plan: null where the place is not known
 */
function Replay({ app, left, trial, plan, line, head, store }) {
  /** @param {FloorPlan} known @param {AbortSignal} gone */
  const fromAbove = (known, gone) => {
    const picture = replayPlan(known, trial, line, t("replay-plan"));
    head.follow(picture.show, gone);
    return picture.element;
  };
  return h(
    "section",
    { class: "replay", "aria-label": t("replay-title") },
    line.message && h("p", { class: "problem" }, line.message),
    h(
      "div",
      { class: "replay-columns" },
      h(
        "div",
        { class: "replay-pictures" },
        h(ReplayView, { app, trial, plan, line, head, left }),
        plan &&
          h(
            "section",
            { class: "card replay-plan" },
            h("h2", {}, t("replay-plan")),
            h(Made, { left, make: (gone) => fromAbove(plan, gone) }),
          ),
      ),
      h(
        "div",
        { class: "replay-lines" },
        h(CommentsCard, { store, head }),
        h(ReplayCharts, { line, head, left }),
        h(EventList, { events: line.events, head }),
      ),
    ),
    h(PlayBar, { head, events: line.events }, h(CommentMarks, { store, head })),
    h("p", { class: "quiet small" }, t("replay-keys")),
  );
}
