/**
 * A running trial: the picture fills the page; over it time, place, plan, speed, and what can be done.
 * @import { TrialStore } from "./trial_store.js"
 */
import { drawPage, Fragment, h, useFocusWithin, useRef } from "../../preact.js";
import { t } from "../../texts.js";
import { SpeedDial } from "../../widgets/dial.js";
import { number } from "../../widgets/format.js";
import { Made, useUntilGone } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { PlaceCard } from "./place_card.js";
import { trialStore } from "./trial_store.js";

const PAUSES = 3; // in one trial, after which the drawn plan is offered

/**
 * Show the picture and what lies over it; `begin` of what is returned is called with the trial once it runs.
 * @param {import("../../main.js").App} app @param {HTMLElement} root @param {Parameters<typeof trialStore>[1]} what
 * @param {AbortSignal} left
 */
export function showTrial(app, root, what, left) {
  const store = trialStore(app, what, left);
  root.className = "page filled";
  drawPage(root, h(Trial, { store }), "trial");
  app.setShowsTrial(true);
  store.followPicture();
  return store;
}

/** @param {{store: TrialStore}} page */
function Trial({ store }) {
  const { app, left, plan, title, picture, mini, cue, views, isVisitor } = store;
  return h(
    Fragment,
    {},
    h("h1", { class: "unseen", tabindex: -1 }, title.value ?? plan.title),
    h(Made, { left, make: () => picture.element }),
    h(PlaceCard, { store }),
    h(Made, { left, make: () => mini.element }),
    h(Made, { left, make: () => cue.element }),
    h(
      "div",
      { class: "lower" },
      h(
        "div",
        { class: "above-bar" },
        h(PlanOffer, { store }),
        h("div", { class: "hud dial-card" }, h("b", { class: "small" }, t("dial-title")), h(SpeedDial, { app, left })),
        h(Made, { class: "in-place", left, make: () => views.pad }),
        h(Made, { class: "in-place", left, make: () => picture.drawn.pad }),
      ),
      isVisitor && h(Made, { class: "pad-dock", left, make: (gone) => pads(app, gone, { hasNote: false }).element }),
      h(Bar, { store }),
    ),
  );
}

/** The drawn plan by one button, once the 3D view has paused the trial too often. @param {{store: TrialStore}} offer */
function PlanOffer({ store: { moment, shows, views } }) {
  useFocusWithin(".plan-offer", ".view-bar input:checked");
  const pauses = moment.value?.trial?.pauses ?? 0;
  return h(
    "div",
    { class: "hud plan-offer", hidden: pauses < PAUSES || shows.value === "plan" },
    h("p", {}, t("trial-pause-often")),
    h("button", { type: "button", class: "btn go", onClick: views.choosePlan }, t("picture-plan-show")),
  );
}

/** @param {{store: TrialStore}} bar */
function Bar({ store }) {
  const { left, path, trial, moment, shows, isEnding, isPlotsOpen, picture, square, views } = store;
  const bar = useRef(/** @type {HTMLDivElement | null} */ (null));
  useUntilGone(left, (gone) => {
    const { current: element } = bar;
    if (!element) return;
    // The picture ends above the bar, which would hide the path right before the chair.
    const size = new ResizeObserver(() => picture.element.style.setProperty("--below", `${element.offsetHeight}px`));
    size.observe(element);
    gone.addEventListener("abort", () => size.disconnect());
  });
  const speed = number(moment.value ? moment.value.v : 0, 2);
  const isOff = !trial.value || isEnding.value;
  return h(
    "div",
    { class: "hud bar", ref: bar },
    h(
      "div",
      { class: "speed" },
      h("div", { class: "quiet small" }, t("trial-speed")),
      h("div", { class: "big" }, h("span", {}, speed), " ", h("small", {}, t("unit-speed"))),
    ),
    h(Made, { class: "in-place", left, make: () => square.element }),
    h("p", { class: "grow instruction" }, moment.value?.trial?.instruction ?? path.instruction),
    h(
      "div",
      { class: "spread actions" },
      h(Made, { class: "in-place", left, make: () => views.element }),
      h(
        "button",
        {
          type: "button",
          class: "btn wide-only",
          "aria-pressed": isPlotsOpen.value,
          disabled: shows.value !== "view",
          onClick: () => store.setPlots(!isPlotsOpen.value),
        },
        t("trial-plots"),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn end",
          "aria-disabled": isOff || undefined,
          onClick: () => void (isOff || store.end()),
        },
        t(isEnding.value ? "trial-ending" : "trial-end"),
      ),
    ),
  );
}
