/**
 * What would change of the map, and why: joint by joint, applied by a person or by itself, and one tap back.
 * @import { AdaptationView, ProposalView } from "types/api"
 * @import { MapVersion } from "types/documents"
 * @import { Child } from "types/dom"
 * @typedef {AdaptationView["mode"]} Mode
 */
import { failureWords } from "../../api.js";
import { effectCard } from "./adapt_effect.js";
import { jointCards } from "./adapt_joints.js";
import { h, put, write } from "../../widgets/dom.js";
import { choices } from "../../widgets/fields.js";
import { percent } from "../../widgets/format.js";
import { labelsOf } from "../../widgets/joint_words.js";
import { mapVersions } from "./map_versions.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { t } from "../../texts.js";

/** @type {Mode[]} */
const MODES = ["off", "suggest", "auto"];
const CONCERNS = ["adaptation", "controls", "trial", "drive", "equipment", "everything"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page `#/adapt/look` looks at once */
export async function show(app, root, { signal, rest }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile)
    return emptyPage(root, t("adapt-none-title"), t("adapt-none-lead"), "#/calibrate", t("controls-none-go"));
  const mayChange = app.me?.role !== "reviewer";
  const [lead, problem] = [h("p", { class: "lead" }), h("p", { class: "problem", role: "alert" })];
  const [place, versions, foot] = [h("div", { class: "stack" }), h("div", {}), h("div", { class: "foot" })];
  const modePlace = h("div", {});
  /** @type {Mode | null} */
  let shownMode = null;

  /** @param {AdaptationView} view @param {MapVersion[]} maps */
  const draw = (view, maps) => {
    const labels = labelsOf(view.proposal?.joints ?? []); // of the joints that the proposal names
    write(lead, t(`adapt-lead-${view.origin}`, { version: view.version ?? "" }));
    put(
      place,
      view.looking && h("p", { class: "card quiet", role: "status" }, t("adapt-looking")),
      proposalCards(view),
    );
    put(versions, mapVersions(maps, labels));
    put(foot, mayChange && buttons(view));
    if (view.mode !== shownMode) put(modePlace, modeCard(view.mode, mayChange, choose));
    shownMode = view.mode;
  };
  const read = async () => {
    const [view, maps] = await Promise.all([
      app.api.get("/adaptation"),
      app.api.get(`/patients/${here.patient.id}/maps`),
    ]);
    if (!signal.aborted) draw(view, /** @type {MapVersion[]} */ (maps));
    return view;
  };
  /** Make a change, and read again how things are. @param {() => Promise<AdaptationView>} change */
  const ask = async (change) => {
    write(problem, "");
    for (const button of foot.querySelectorAll("button")) button.disabled = true;
    try {
      const view = await change();
      await read();
      return view;
    } catch (error) {
      await read().catch(() => null);
      write(problem, failureWords(error));
      return null;
    }
  };
  /** @param {Mode} mode */
  const choose = async (mode) => {
    shownMode = mode; // the card is not drawn again, so that it keeps the focus
    await ask(() => app.api.put("/adaptation", { mode }));
  };
  /** @param {string} proposal its id */
  const apply = async (proposal) => {
    const view = await ask(() => app.api.post("/adaptation/apply", { proposal }));
    if (view)
      app.toasts.show(t("adapt-applied-toast", { version: view.version ?? "" }), { action: t("undo"), run: back });
  };
  const back = async () => {
    const to = (await app.api.get("/adaptation")).back_to;
    const view = await ask(() => app.api.post("/adaptation/back"));
    if (view) app.toasts.show(t("adapt-back-toast", { to: to ?? "", version: view.version ?? "" }));
  };
  const look = () => ask(() => app.api.post("/adaptation/propose"));
  /** @param {AdaptationView} view @returns {Child[]} */
  const buttons = (view) => {
    const { back_to: before, refusal } = view;
    const waits = waiting(view);
    return [
      before !== null && button(t("adapt-back", { version: before }), back),
      h("span", { class: "grow" }),
      waits && button(t("adapt-later"), () => ask(() => app.api.post("/adaptation/dismiss", { proposal: waits.id }))),
      waits && button(t("adapt-apply"), () => apply(waits.id), "btn go", refusal !== null),
      !waits && button(t("adapt-look"), look, "btn", !mayLook(view)),
      !waits && h("a", { class: "btn go", href: "#/drive" }, t("rail-drive")),
    ];
  };

  let moment = "";
  // What may be applied depends on the chair too, which tells no other news when it stands again or a stop is taken back.
  app.live.addEventListener(
    "tick",
    ({ detail: { state, v } }) => {
      const before = moment;
      moment = `${state} ${v ? "moves" : "stands"}`;
      if (before && moment !== before) read().catch(() => null);
    },
    { signal },
  );
  app.live.addEventListener("changed", ({ detail }) => CONCERNS.includes(detail.what) && read().catch(() => null), {
    signal,
  });
  const view = await read();
  if (signal.aborted) return;
  if (rest[0] === "look") {
    history.replaceState(null, "", "#/adapt"); // so that a reload looks at what was found
    if (mayChange && mayLook(view)) look();
  }
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("adapt-title")),
      lead,
      problem,
      h("div", { class: "stack" }, place, modePlace, versions),
    ),
    foot,
  );
}

/** The proposal that waits for a person; null when none does. @param {AdaptationView} view */
const waiting = ({ proposal }) => (proposal?.changes && proposal.applied === null ? proposal : null);

/** Whether a look at the last trials can begin now. @param {AdaptationView} view */
const mayLook = (view) => !waiting(view) && !view.looking && view.refusal === null;

/** @param {string} words @param {() => void} run */
function button(words, run, kind = "btn", disabled = false) {
  return h("button", { type: "button", class: kind, onclick: run, disabled }, words);
}

/** @param {AdaptationView} view @returns {Child[]} */
function proposalCards(view) {
  const { proposal } = view;
  if (!proposal)
    return [h("p", { class: "card adapt-why" }, view.why), view.refusal && h("p", { class: "problem" }, view.refusal)];
  return [headline(view, proposal), proposal.effect && effectCard(proposal.effect), jointCards(proposal)];
}

/**
 * The summary: how much is felt, what changes, and what it means for a real chair.
 * @param {AdaptationView} view @param {ProposalView} proposal
 */
function headline({ refusal, practised }, proposal) {
  const { felt_change: felt, warns, applied, changes } = proposal;
  const figure = changes
    ? h(
        "div",
        { class: "adapt-felt" },
        h("span", { class: "quiet" }, t("adapt-felt")),
        h("b", { class: "big" }, percent(felt)),
      )
    : h("b", { class: "adapt-nothing" }, t("adapt-felt-none"));
  const practice = applied === null ? changes && t("adapt-practise-next") : practisedWords(practised);
  return h(
    "section",
    { class: `card adapt-head ${warns ? "warns" : ""}` },
    figure,
    h(
      "div",
      { class: "grow" },
      h("p", { class: "adapt-reason" }, applied === null ? proposal.reason : t("adapt-in-use", { version: applied })),
      changes && h("p", { class: warns ? "attention" : "quiet" }, t(warns ? "adapt-felt-warns" : "adapt-felt-little")),
      practice && h("p", { class: "small" }, practice),
      proposal.message && h("p", { class: "small" }, proposal.message),
      applied === null && changes && refusal && h("p", { class: "problem" }, refusal),
    ),
  );
}

/** @param {number} count of the trials that were driven with the map in use */
function practisedWords(count) {
  return count ? t("adapt-practise-some", { count }) : t("adapt-practise-none");
}

/** @param {Mode} mode @param {boolean} mayChange @param {(mode: Mode) => void} choose */
function modeCard(mode, mayChange, choose) {
  const options = MODES.map((value) => ({
    value,
    label: t(`adapt-mode-${value}`),
    hint: t(`adapt-mode-${value}-hint`),
  }));
  const chosen = h("p", {}, h("b", {}, t(`adapt-mode-${mode}`)), ". ", t(`adapt-mode-${mode}-hint`));
  return h(
    "section",
    { class: "card adapt-mode" },
    h("h2", {}, t("adapt-mode")),
    mayChange ? choices(t("adapt-mode"), options, mode, choose) : chosen,
    h("p", { class: "quiet small" }, t("adapt-mode-never")),
  );
}
