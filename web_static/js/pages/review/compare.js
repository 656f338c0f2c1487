/**
 * Two trials side by side: on one plan, along the path, and in their measures.
 * @import { App } from "../../main.js"
 * @import { TrialDetail } from "types/api"
 */
import { failureWords } from "../../api.js";
import { compareReplay } from "./compare_replay.js";
import { compareTable } from "./compare_table.js";
import { h, put } from "../../widgets/dom.js";
import { moment } from "../../widgets/format.js";
import { groupMark, groupOf } from "../../results/source_group.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest: [patient, , ...ids] }) {
  if (ids.length < 2) throw new Error(t("compare-pairs"));
  const trials = await Promise.all(ids.slice(0, 2).map((id) => app.api.get(`/trials/${id}`)));
  trials.sort((a, b) => a.id - b.id);
  if (signal.aborted) return;
  app.setSubject({ code: trials[0].patient_code, sessions: trials.map((trial) => trial.session_number) });
  const found = await verdicts(app, trials);
  const above = await pictures(app, root, trials, signal);
  if (signal.aborted) return;
  /** @param {TrialDetail} trial */
  const link = (trial) =>
    h(
      "a",
      { href: `#/review/${patient}/trial/${trial.id}` },
      t("compare-trial", { number: trial.number }),
      ` (${moment(trial.started)})`,
    );
  /** @param {TrialDetail} trial */
  const named = (trial) => h("span", { class: "trial-name" }, link(trial), " ", groupMark(groupOf(trial)));
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("compare-title")),
      h(
        "p",
        { class: "lead compare-lead" },
        trials[0].floorplan_title,
        ": ",
        named(trials[0]),
        " · ",
        named(trials[1]),
      ),
      above,
      compareTable(trials, found),
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: `#/review/${patient}` }, t("review-back")),
    ),
  );
}

/**
 * What is better than noise in the later trial; null where the two cannot be compared.
 * @param {App} app @param {TrialDetail[]} trials two, the earlier first
 */
async function verdicts(app, [first, second]) {
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
 * What can be shown of both together, or why nothing can.
 * @param {App} app @param {HTMLElement} root @param {TrialDetail[]} trials two @param {AbortSignal} signal
 */
async function pictures(app, root, trials, signal) {
  const [first, second] = trials;
  if (!isSameTask(first, second)) return h("p", { class: "card quiet" }, t("compare-other-path"));
  try {
    const lines = await Promise.all(trials.map(({ id }) => app.api.get(`/trials/${id}/timeline`)));
    const plan = lines[1].floorplan ?? (await app.api.get(`/floorplans/${first.floorplan}`).catch(() => null));
    return await compareReplay(root, trials, lines, plan, signal);
  } catch (error) {
    return h("p", { class: "card quiet" }, t("compare-no-recording", { why: failureWords(error) }));
  }
}
