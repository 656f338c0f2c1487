/**
 * Two trials side by side: on one plan, along the path, and in their measures.
 * @import { App } from "../../main.js"
 * @import { TrialDetail } from "types/api"
 */
import { failureWords } from "../../api.js";
import { drawFoot, drawPage, h } from "../../preact.js";
import { GroupMark, groupOf } from "../../results/source_group.js";
import { t } from "../../texts.js";
import { moment } from "../../widgets/format.js";
import { CompareReplay } from "./compare_replay.js";
import { CompareTable } from "./compare_table.js";
import { playKeys } from "./play_bar.js";
import { PlayHead } from "./play_head.js";

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest: [patient, , ...ids] }) {
  if (ids.length < 2) throw new Error(t("compare-pairs"));
  const trials = await Promise.all(ids.slice(0, 2).map((id) => app.api.get(`/trials/${id}`)));
  trials.sort((a, b) => a.id - b.id);
  if (left.aborted) return;
  const { patient_id: id, patient_code: code } = trials[0];
  app.setSubject({ patient: id, code, sessions: trials.map((trial) => trial.session_number) });
  const [verdicts, recorded] = await Promise.all([verdictsOf(app, trials), recordingsOf(app, trials)]);
  if (left.aborted) return;
  /** @param {TrialDetail} trial */
  const named = (trial) => {
    const words = `${t("compare-trial", { number: trial.number })} (${moment(trial.started)})`;
    const link = h("a", { href: `#/review/${patient}/trial/${trial.id}` }, words);
    return h("span", { class: "trial-name" }, link, " ", h(GroupMark, { group: groupOf(trial) }));
  };
  const [first, second] = trials;
  const { lines, plan = null, why } = recorded;
  const head = lines && new PlayHead(0, Math.max(...lines.map(({ t: times }) => Number(times.at(-1)))), left);
  if (head) playKeys(root, head, left);
  drawPage(root, [
    h("h1", { tabindex: -1 }, t("compare-title")),
    h("p", { class: "lead compare-lead" }, first.floorplan_title, ": ", named(first), " · ", named(second)),
    lines && head ? h(CompareReplay, { app, left, trials, lines, plan, head }) : h("p", { class: "card quiet" }, why),
    h(CompareTable, { trials, verdicts }),
  ]);
  const back = h("a", { class: "btn", href: `#/review/${patient}` }, t("review-back"));
  drawFoot(root, [h("span", { class: "grow" }), back]);
}

/**
 * What is better than noise in the later trial; null where the two cannot be compared.
 * @param {App} app @param {TrialDetail[]} trials two, the earlier first
 */
async function verdictsOf(app, [first, second]) {
  const isSame = isSameTask(first, second) && groupOf(first) === groupOf(second);
  return isSame && first.id !== second.id ? app.api.get(`/trials/${second.id}/verdicts?against=${first.id}`) : null;
}

/** @param {TrialDetail} first @param {TrialDetail} second */
function isSameTask(first, second) {
  return (
    first.patient_id === second.patient_id &&
    first.floorplan === second.floorplan &&
    first.path_name === second.path_name
  );
}

/**
 * The time lines of both trials and their place, or why they cannot be shown together.
 * @param {App} app @param {TrialDetail[]} trials two
 */
async function recordingsOf(app, trials) {
  const [first, second] = trials;
  if (!isSameTask(first, second)) return { why: t("compare-other-path") };
  try {
    const lines = await Promise.all(trials.map(({ id }) => app.api.get(`/trials/${id}/timeline`)));
    const plan = lines[1].floorplan ?? (await app.api.get(`/floorplans/${first.floorplan}`).catch(() => null));
    return { lines, plan };
  } catch (error) {
    return { why: t("compare-no-recording", { why: failureWords(error) }) };
  }
}
