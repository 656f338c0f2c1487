/**
 * A trial that is over: its figures, keep or discard, and the next one in one tap.
 * @import { App } from "../main.js"
 * @import { TrialDetail } from "types/api"
 * @import { ComponentChildren } from "../preact.js"
 * @typedef {Awaited<ReturnType<typeof readTrial>>} TrialReading a trial with all that stands beside it
 * @typedef {ReturnType<typeof trialOverStore>} TrialOverStore
 */
import { passFocus } from "../focus.js";
import { drawFoot, drawPage, Fragment, h, signal, useOpening } from "../preact.js";
import { t } from "../texts.js";
import { DiscardForm } from "./discard.js";
import { moment } from "../widgets/format.js";
import { isInterrupted } from "./interruptions.js";
import { QualityCard } from "./quality_card.js";
import { GroupMark, groupOf } from "./source_group.js";
import { TrialSummary } from "./trial_summary.js";

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
 * @param {App} app @param {HTMLElement} root @param {TrialReading} first
 * @param {object} parts
 * @param {AbortSignal} parts.left
 * @param {(trial: TrialDetail) => ComponentChildren} parts.actions what stands at the right of the foot
 * @param {ComponentChildren} [parts.above] what stands before the figures; without it, a link leads to the replay
 */
export function showTrialOver(app, root, first, { left, actions, above }) {
  const store = trialOverStore(app, first);
  drawPage(root, h(Page, { store, left, above }));
  drawFoot(root, h(Foot, { store, actions, hasReplay: Boolean(above) }));
}

/** @param {App} app @param {TrialReading} first */
function trialOverStore(app, first) {
  const reading = signal(first);
  const asked = signal(0); // how often somebody wished to discard the trial; 0: the form is closed
  const { id, number } = first.trial;
  const ask = () => void asked.value++;
  const close = () => void (asked.value = 0);
  /** Send a change and read the trial again; answer whether that was done. @param {() => Promise<unknown>} send */
  const change = (send) =>
    app.toasts.attempt(async () => {
      await send();
      reading.value = await readTrial(app.api, id);
      close();
      return true;
    });
  const keep = () => change(() => app.api.post(`/trials/${id}/keep`));
  /** @param {string} reason */
  const leaveOut = (reason) => change(() => app.api.post(`/trials/${id}/discard`, { reason }));
  /** @param {string} reason */
  const discard = async (reason) => {
    if (!(await leaveOut(reason))) return;
    app.toasts.show(t("over-discarded-toast", { number }), { action: t("undo"), run: keep });
  };
  /** Keep a trial that was left out because it was interrupted. */
  const count = async () => {
    const reason = reading.value.trial.discard_reason ?? "";
    if (!(await keep())) return;
    app.toasts.show(t("over-counted-toast", { number }), { action: t("undo"), run: () => leaveOut(reason) });
  };
  return { app, reading, asked, ask, close, keep, discard, count };
}

/** @param {{store: TrialOverStore, left: AbortSignal, above: ComponentChildren}} page */
function Page({ store: { reading, asked, discard, close }, left, above }) {
  const { trial, plan } = reading.value;
  const formPlace = useOpening(asked.value);
  const path = plan?.paths.find(({ name }) => name === trial.path_name)?.title ?? trial.path_name;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t(`over-${trial.end}`)),
    h(
      "p",
      { class: "lead" },
      t("over-lead", { number: trial.number, plan: trial.floorplan_title, path, when: moment(trial.started) }),
    ),
    h(
      "p",
      { class: "quiet small" },
      h(GroupMark, { group: groupOf(trial) }),
      " ",
      t("over-source", { source: trial.source.description }),
    ),
    above,
    h(TrialSummary, { reading: reading.value, left }),
    h(QualityCard, { quality: trial.quality }),
    h("div", { ref: formPlace }, asked.value > 0 && h(DiscardForm, { onDiscard: discard, onClose: close })),
  );
}

/**
 * @param {{store: TrialOverStore, actions: (trial: TrialDetail) => ComponentChildren, hasReplay: boolean}} foot
 *   hasReplay: whether the page shows the replay
 */
function Foot({ store, actions, hasReplay }) {
  const { trial } = store.reading.value;
  return h(
    Fragment,
    {},
    store.app.me?.role !== "reviewer" && keeping(store),
    !hasReplay && h("a", { class: "btn", href: `#/review/${trial.patient_id}/trial/${trial.id}` }, t("replay-look")),
    h("span", { class: "grow" }),
    actions(trial),
  );
}

/** The button that decides whether the trial counts. @param {TrialOverStore} store */
function keeping({ reading, ask, count, keep }) {
  const { kept, measures } = reading.value.trial;
  /** @param {"discard" | "count" | "keep"} what @param {() => unknown} onClick */
  const button = (what, onClick) =>
    h("button", { key: what, type: "button", class: "btn", ref: passFocus, onClick }, t(`over-${what}`));
  if (kept) return button("discard", ask);
  return isInterrupted(measures) ? button("count", count) : button("keep", keep);
}
