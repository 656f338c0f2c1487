/** The rail: the six steps of a session, which of them are done, where one is, and the settings. */
import { t } from "../texts.js";
import { h, set } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";

const STEPS = /** @type {const} */ (["patients", "shirt", "calibrate", "controls", "drive", "review"]);
const RAIL = /** @type {const} */ ([...STEPS, "settings"]);
const FOR_REVIEWERS = ["patients", "review", "settings"]; // who looks, and changes nothing
/** @type {Record<string, string>} pages without a step of their own, and the step that they belong to */
const BELOW = { interface_test: "drive", attention: "review" };
const IN_SETTINGS = ["plans", "people", "log", "computer", "backup"]; // opened from there: the rail marks the settings
/** @type {string[]} */
export const PAGES = [...RAIL, "attention", "session", "adapt", "interface_test", ...IN_SETTINGS]; // those that have an address of their own

/**
 * The steps of the open session that are done, up to the first that is not: a step behind one that has to be done
 * anew, such as a calibration without a shirt that sends, has no tick.
 * @param {import("../main.js").App} app @returns {readonly string[]}
 */
function stepsDone(app) {
  const { patient = null, has_profile: hasProfile = false, obstacle = null } = app.session ?? {};
  /** @type {Record<string, boolean | undefined>} */
  const isDone = {
    patients: patient !== null,
    shirt: app.live.present?.shirt.alive,
    calibrate: hasProfile,
    controls: hasProfile,
    drive: patient !== null && patient.trials > 0,
  };
  const first = STEPS.findIndex((step) => !isDone[step] || step === obstacle?.page);
  return STEPS.slice(0, first);
}

/** @param {import("../main.js").App} app */
export function rail(app) {
  const links = RAIL.map((step) => {
    const mark = h(
      "span",
      { class: "done", hidden: true },
      icon("tick", 14),
      h("span", { class: "unseen" }, t("rail-done")),
    );
    const link = h("a", { href: `#/${step}` }, icon(step), h("span", {}, t(`rail-${step}`)), mark);
    return { step, link, mark };
  });
  const show = () => {
    const done = stepsDone(app);
    for (const { step, link, mark } of links) {
      mark.hidden = !done.includes(step);
      const isAbove = step === "settings" ? IN_SETTINGS.includes(app.route.page) : BELOW[app.route.page] === step;
      link.hidden = app.me?.role === "reviewer" && !FOR_REVIEWERS.includes(step);
      set(link, { "aria-current": step === app.route.page ? "page" : isAbove ? "true" : null });
    }
  };
  for (const event of /** @type {const} */ (["session", "route", "me"])) app.addEventListener(event, show);
  app.live.addEventListener("quality", show);
  app.live.addEventListener("connection", show);
  show();
  return h(
    "nav",
    { class: "rail", "aria-label": t("rail-label") },
    links.map(({ link }) => link),
  );
}
