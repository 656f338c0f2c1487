/**
 * What would change of the map, and why: joint by joint, applied by a person or by itself, and one tap back.
 * @import { AdaptationView, ProposalView } from "types/api"
 * @import { AdaptStore, Mode } from "./store.js"
 */
import { EffectCard } from "./adapt_effect.js";
import { JointCards } from "./adapt_joints.js";
import { drawFoot, drawPage, Fragment, h, useFocusWithin } from "../../preact.js";
import { Choices } from "../../widgets/fields.js";
import { percent } from "../../widgets/format.js";
import { labelsOf } from "../../widgets/joint_words.js";
import { MapVersions } from "./map_versions.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { adaptStore, mayLook, waiting } from "./store.js";
import { t } from "../../texts.js";

/** @type {Mode[]} */
const MODES = ["off", "suggest", "auto"];

/**
 * @param {import("../../main.js").App} app @param {HTMLElement} root
 * @param {{signal: AbortSignal, rest: string[]}} page `#/adapt/look` looks at once
 */
export async function show(app, root, { signal: left, rest }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile)
    return emptyPage(root, t("adapt-none-title"), t("adapt-none-lead"), "#/calibrate", t("controls-none-go"));
  const store = await adaptStore(app, here.patient.id, left);
  if (left.aborted) return;
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
  if (rest[0] !== "look") return;
  history.replaceState(null, "", "#/adapt"); // so that a reload looks at what was found
  if (store.mayChange && mayLook(store.view.value)) store.look();
}

/** @param {{store: AdaptStore}} page */
function Page({ store }) {
  const { origin, version, looking, proposal } = store.view.value;
  const labels = labelsOf(proposal?.joints ?? []); // of the joints that the proposal names
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("adapt-title")),
    h("p", { class: "lead" }, t(`adapt-lead-${origin}`, { version: version ?? "" })),
    h("p", { class: "problem", role: "alert" }, store.problem),
    h(
      "div",
      { class: "stack" },
      h(
        "div",
        { class: "stack" },
        looking && h("p", { class: "card quiet", role: "status" }, t("adapt-looking")),
        h(Proposal, { view: store.view.value }),
      ),
      h(ModeCard, { store }),
      h(MapVersions, { maps: store.maps.value, labels }),
    ),
  );
}

/** @param {{store: AdaptStore}} foot */
function Foot({ store: { view, isBusy, mayChange, look, dismiss, apply, back } }) {
  useFocusWithin(".foot"); // what was found is to be read first
  if (!mayChange) return null;
  const { back_to: before, refusal } = view.value;
  const proposal = waiting(view.value);
  /** @param {string} key @param {string} words @param {() => void} onClick */
  const button = (key, words, onClick, kind = "btn", isOff = isBusy.value) =>
    h(
      "button",
      {
        key,
        type: "button",
        class: kind,
        "aria-disabled": isOff || undefined,
        onClick: () => void (isOff || onClick()),
      },
      words,
    );
  return h(
    Fragment,
    {},
    before !== null && button("back", t("adapt-back", { version: before }), back),
    h("span", { key: "grow", class: "grow" }),
    proposal && button("later", t("adapt-later"), () => dismiss(proposal.id)),
    proposal && button("apply", t("adapt-apply"), () => apply(proposal.id), "btn go", isBusy.value || refusal !== null),
    !proposal && button("look", t("adapt-look"), look, "btn", isBusy.value || !mayLook(view.value)),
    !proposal && h("a", { key: "drive", class: "btn go", href: "#/drive" }, t("rail-drive")),
  );
}

/** The cards of a proposal, or why there is none. @param {{view: AdaptationView}} cards */
function Proposal({ view }) {
  const { proposal, why, refusal } = view;
  if (!proposal)
    return h(Fragment, {}, h("p", { class: "card adapt-why" }, why), refusal && h("p", { class: "problem" }, refusal));
  return h(
    Fragment,
    {},
    h(Headline, { view, proposal }),
    proposal.effect && h(EffectCard, { effect: proposal.effect }),
    h(JointCards, { proposal }),
  );
}

/**
 * The summary: how much is felt, what changes, and what it means for a real chair.
 * @param {{view: AdaptationView, proposal: ProposalView}} headline
 */
function Headline({ view: { refusal, practised }, proposal }) {
  const { felt_change: felt, warns, applied, changes } = proposal;
  const practice = applied === null ? changes && t("adapt-practise-next") : practisedWords(practised);
  return h(
    "section",
    { class: `card adapt-head ${warns ? "warns" : ""}` },
    changes
      ? h(
          "div",
          { class: "adapt-felt" },
          h("span", { class: "quiet" }, t("adapt-felt")),
          h("b", { class: "big" }, percent(felt)),
        )
      : h("b", { class: "adapt-nothing" }, t("adapt-felt-none")),
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

/** @param {{store: AdaptStore}} card */
function ModeCard({ store: { view, wanted, mayChange, choose } }) {
  const mode = wanted.value ?? view.value.mode;
  const options = MODES.map((value) => ({
    value,
    label: t(`adapt-mode-${value}`),
    hint: t(`adapt-mode-${value}-hint`),
  }));
  return h(
    "section",
    { class: "card adapt-mode" },
    h("h2", {}, t("adapt-mode")),
    mayChange
      ? h(Choices, {
          label: t("adapt-mode"),
          options,
          chosen: mode,
          onChange: (/** @type {string} */ value) => choose(/** @type {Mode} */ (value)),
        })
      : h("p", {}, h("b", {}, t(`adapt-mode-${mode}`)), ". ", t(`adapt-mode-${mode}-hint`)),
    h("p", { class: "quiet small" }, t("adapt-mode-never")),
  );
}
