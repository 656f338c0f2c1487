/**
 * The rail: the six steps of a session, which of them are done, where one is, and the settings.
 * @import { FrameState } from "./frame_state.js"
 */
import { h, render, useComputed } from "../preact.js";
import { t } from "../texts.js";
import { h as element } from "../widgets/dom.js";
import { Icon } from "../widgets/icons.js";

const STEPS = /** @type {const} */ (["patients", "shirt", "calibrate", "controls", "drive", "review"]);
const RAIL = /** @type {const} */ ([...STEPS, "settings"]);
const FOR_REVIEWERS = ["patients", "review", "settings"]; // who looks, and changes nothing
/** @type {Record<string, string>} pages without a step of their own, and the step that they belong to */
const BELOW = { import_recording: "shirt", interface_test: "drive", attention: "review" };
const IN_SETTINGS = ["plans", "people", "log", "computer", "backup"]; // opened from there: the rail marks the settings
/** @type {string[]} */
export const PAGES = [
  ...RAIL, // and the others that have an address of their own
  ...["import_recording", "attention", "session", "adapt", "interface_test"],
  ...IN_SETTINGS,
];

/**
 * How many steps of the open session are done, up to the first that is not: a step behind one that has to be done
 * anew, such as a calibration without a shirt that sends, has no tick.
 * @param {FrameState} state
 */
function stepsDone({ session, picture }) {
  const { patient = null, has_profile: hasProfile = false, obstacle = null } = session.value ?? {};
  /** @type {Record<string, boolean | undefined>} */
  const isDone = {
    patients: patient !== null,
    shirt: picture.value.present?.shirt.alive,
    calibrate: hasProfile,
    controls: hasProfile,
    drive: patient !== null && patient.trials > 0,
  };
  return STEPS.findIndex((step) => !isDone[step] || step === obstacle?.page);
}

/** @param {import("../main.js").App} app */
export function rail({ state }) {
  const nav = element("nav", { class: "rail", "aria-label": t("rail-label") });
  render(h(Links, { state }), nav);
  return nav;
}

/** @param {{state: FrameState}} links */
function Links({ state }) {
  const done = useComputed(() => stepsDone(state)).value;
  const page = state.page.value;
  const isReviewer = state.me.value?.role === "reviewer";
  return RAIL.map((step, i) => {
    const isAbove = step === "settings" ? IN_SETTINGS.includes(page) : BELOW[page] === step;
    return h(
      "a",
      {
        key: step,
        href: `#/${step}`,
        hidden: isReviewer && !FOR_REVIEWERS.includes(step),
        "aria-current": step === page ? "page" : isAbove ? "true" : undefined,
      },
      h(Icon, { name: step }),
      h("span", {}, t(`rail-${step}`)),
      h(
        "span",
        { class: "done", hidden: i >= done },
        h(Icon, { name: "tick", size: 14 }),
        h("span", { class: "unseen" }, t("rail-done")),
      ),
    );
  });
}
