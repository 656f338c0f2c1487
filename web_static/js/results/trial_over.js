/**
 * A trial that is over: its figures, keep or discard, and the next one in one tap.
 * @import { TrialDetail } from "types/api"
 * @import { Child } from "types/dom"
 * @typedef {Awaited<ReturnType<typeof readTrial>>} TrialReading a trial with all that stands beside it
 */
import { t } from "../texts.js";
import { discardForm } from "./discard.js";
import { h, put } from "../widgets/dom.js";
import { moment } from "../widgets/format.js";
import { isInterrupted } from "./interruptions.js";
import { qualityCard } from "./quality_card.js";
import { groupMark, groupOf } from "./source_group.js";
import { trialSummary } from "./trial_summary.js";

/**
 * Read a trial with all that stands beside it.
 * @param {import("../api.js").Api} api @param {string | number} id
 */
export async function readTrial(api, id) {
  const trial = await api.get(`/trials/${id}`);
  const [trials, plans, verdicts] = await Promise.all([
    api.get(`/trials?patient=${trial.patient_id}`),
    api.get("/floorplans"),
    trial.kept && trial.measures ? api.get(`/trials/${trial.id}/verdicts`).catch(() => null) : null, // figures stand without
  ]);
  const plan = plans.some(({ name }) => name === trial.floorplan)
    ? await api.get(`/floorplans/${trial.floorplan}`)
    : null;
  return { trial, trials, plan, verdicts };
}

/**
 * @param {import("../main.js").App} app @param {HTMLElement} root @param {TrialReading} read
 * @param {(trial: TrialDetail) => Child[]} actions what stands at the right of the foot
 * @param {Node} [above] what stands before the figures; without it, a link leads to the replay
 */
export function showTrialOver(app, root, read, actions, above) {
  const { trial, trials, plan, verdicts } = read;
  const place = h("div", {});
  const path = plan?.paths.find(({ name }) => name === trial.path_name)?.title ?? trial.path_name;
  const again = async () => showTrialOver(app, root, await readTrial(app.api, trial.id), actions, above);
  /** @param {() => Promise<unknown>} change */
  const call = (change) =>
    app.toasts.attempt(async () => {
      await change();
      await again();
    });
  const keep = () => call(() => app.api.post(`/trials/${trial.id}/keep`));
  /** @param {string} reason */
  const discard = async (reason) => {
    await call(() => app.api.post(`/trials/${trial.id}/discard`, { reason }));
    app.toasts.show(t("over-discarded-toast", { number: trial.number }), {
      action: t("undo"),
      run: keep,
    });
  };
  const ask = () => {
    put(
      place,
      discardForm(discard, () => put(place)),
    );
    place.scrollIntoView({ block: "nearest" });
    place.querySelector("input")?.focus();
  };
  const count = async () => {
    await keep();
    app.toasts.show(t("over-counted-toast", { number: trial.number }), {
      action: t("undo"),
      run: () => call(() => app.api.post(`/trials/${trial.id}/discard`, { reason: trial.discard_reason ?? "" })),
    });
  };
  const mayChange = app.me?.role !== "reviewer";
  const keeping = trial.kept
    ? h("button", { type: "button", class: "btn", onclick: ask }, t("over-discard"))
    : isInterrupted(trial.measures)
      ? h("button", { type: "button", class: "btn", onclick: count }, t("over-count"))
      : h("button", { type: "button", class: "btn", onclick: keep }, t("over-keep"));
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t(`over-${trial.end}`)),
      h(
        "p",
        { class: "lead" },
        t("over-lead", { number: trial.number, plan: trial.floorplan_title, path, when: moment(trial.started) }),
      ),
      h(
        "p",
        { class: "quiet small" },
        groupMark(groupOf(trial)),
        " ",
        t("over-source", { source: trial.source.description }),
      ),
      above,
      trialSummary(trial, trials, plan, verdicts),
      qualityCard(trial),
      place,
    ),
    h(
      "div",
      { class: "foot" },
      mayChange && keeping,
      !above && h("a", { class: "btn", href: `#/review/${trial.patient_id}/trial/${trial.id}` }, t("replay-look")),
      h("span", { class: "grow" }),
      actions(trial),
    ),
  );
}
