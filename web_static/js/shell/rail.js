/**
 * The rail: the steps of a session, which of them are done, where one is, and the settings.
 * @import { FrameState } from "./frame_state.js"
 */
import { h, render, useComputed } from "../preact.js";
import { t } from "../texts.js";
import { h as element } from "../widgets/dom.js";
import { Icon } from "../widgets/icons.js";
import { PAGES, placeOf } from "./pages.js";

const STEPS = Object.entries(PAGES).flatMap(([step, { icon }]) => (icon ? [{ step, icon }] : []));

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
  return STEPS.findIndex(({ step }) => !isDone[step] || step === obstacle?.page);
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
  const { below } = placeOf(page);
  return STEPS.map(({ step, icon }, i) =>
    h(
      "a",
      {
        key: step,
        href: `#/${step}`,
        hidden: isReviewer && !PAGES[step].forReviewers,
        "aria-current": step === page ? "page" : step === below ? "true" : undefined,
      },
      h(Icon, { name: icon }),
      h("span", {}, t(`rail-${step}`)),
      h(
        "span",
        { class: "done", hidden: i >= done },
        h(Icon, { name: "tick", size: 14 }),
        h("span", { class: "unseen" }, t("rail-done")),
      ),
    ),
  );
}
