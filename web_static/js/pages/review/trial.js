/**
 * One trial of Review: its replay, where one slider moves picture, plan and charts together, and what it came to.
 * @import { App } from "../../main.js"
 * @import { Timeline } from "types/api"
 * @typedef {ReturnType<typeof commentsCard>} Comments
 * @import { TrialReading } from "../../results/trial_over.js"
 */
import { commentsCard } from "./comments_card.js";
import { emptyPage } from "../../shell/nobody.js";
import { failureWords } from "../../api.js";
import { h } from "../../widgets/dom.js";
import { PlayHead } from "./play_head.js";
import { eventList, playBar, playKeys } from "./play_bar.js";
import { replayCharts } from "./replay_charts.js";
import { replayDrawn, replayPlan } from "../../plan/replay_plan.js";
import { replayView } from "./replay_view.js";
import { readTrial, showTrialOver } from "../../results/trial_over.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [patient, , id] }) {
  const read = await readTrial(app.api, id);
  if (signal.aborted) return;
  app.setSubject({ code: read.trial.patient_code, sessions: [read.trial.session_number] });
  if (read.trial.status === "running") {
    app.live.addEventListener("changed", ({ detail }) => ["trial", "everything"].includes(detail) && app.show(), {
      signal,
    });
    const title = t("review-running-title", { number: read.trial.number });
    return emptyPage(root, title, t("review-running-lead"), `#/review/${patient}`, t("review-back"));
  }
  let why = "";
  const [line, comments] = await Promise.all([
    app.api.get(`/trials/${id}/timeline`).catch((error) => void (why = failureWords(error))),
    app.api.get(`/trials/${id}/comments`),
  ]);
  if (signal.aborted) return;
  const head = line ? new PlayHead(Number(line.t[0]), Number(line.t.at(-1)), signal) : null;
  const card = commentsCard(app, read.trial.id, comments, head, signal);
  const above =
    line && head
      ? replay(app, root, read, line, head, card, signal)
      : withoutReplay(why, comments.length > 0 && card.element);
  const back = () => [h("a", { class: "btn", href: `#/review/${patient}` }, t("review-back"))];
  showTrialOver(app, root, read, back, above);
}

/** @param {string} why @param {HTMLElement | false} card the comments on the trial, when there are some */
function withoutReplay(why, card) {
  return h("div", { class: "replay" }, h("p", { class: "card quiet" }, t("replay-none"), " ", why), card);
}

/**
 * @param {App} app @param {HTMLElement} root @param {TrialReading} read @param {Timeline} line @param {PlayHead} head
 * @param {Comments} comments @param {AbortSignal} signal
 */
function replay(app, root, { trial, plan }, line, head, comments, signal) {
  const where = line.floorplan ?? plan;
  const fromAbove = where && replayPlan(where, trial, line, t("replay-plan"));
  if (fromAbove) {
    const show = () => fromAbove.show(head.t);
    head.addEventListener("time", show, { signal });
    show();
  }
  const element = h(
    "section",
    { class: "replay", "aria-label": t("replay-title") },
    line.message && h("p", { class: "problem" }, line.message),
    h(
      "div",
      { class: "replay-columns" },
      h(
        "div",
        { class: "replay-pictures" },
        replayView(app, trial.id, where && replayDrawn(where, trial, line), head, signal),
        fromAbove && h("section", { class: "card replay-plan" }, h("h2", {}, t("replay-plan")), fromAbove.element),
      ),
      h(
        "div",
        { class: "replay-lines" },
        comments.element,
        replayCharts(line, head, signal),
        eventList(line.events, head),
      ),
    ),
    playBar(head, line.events, signal, comments.marks),
    h("p", { class: "quiet small" }, t("replay-keys")),
  );
  playKeys(root, head, signal);
  return element;
}
