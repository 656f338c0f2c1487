/**
 * Before a real chair is armed: the chair as it is, what would apply, the body at rest; and what is still missing.
 * @import { App } from "../../main.js"
 * @import { ArmingStore, FullReading } from "./store.js"
 */
import { drawFoot, drawPage, Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { ArmingSummary } from "./arming_summary.js";
import { ChairCard } from "./chair_card.js";
import { NeutralCard } from "./neutral_card.js";
import { armingStore } from "./store.js";

/**
 * @param {App} app @param {HTMLElement} root @param {FullReading} read
 * @param {(id: number) => void} onDrive the chair is driven, from here or from elsewhere @param {AbortSignal} left
 */
export function showArming(app, root, read, onDrive, left) {
  const store = armingStore(app, read, onDrive, left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: ArmingStore}} page */
function Page({ store }) {
  const { app, left, name, chair, isSimulated, isVisitor } = store;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("chair-title", { name })),
    h("p", { class: "lead" }, t(isSimulated ? "chair-lead-simulated" : "chair-lead")),
    isSimulated && h("p", { class: "card simulated" }, t("chair-simulated")),
    h(OpenPoints, { store }),
    h(
      "div",
      { class: "arming" },
      h("div", { class: "stack" }, h(ChairCard, { chair, step: 1 }), h(ArmingSummary, { store, step: 2 })),
      h(NeutralCard, { store, step: 3 }),
    ),
    isVisitor && h(Made, { class: "card pad-card", left, make: (gone) => pads(app, gone).element }),
  );
}

/** What is missing before the chair can be armed, as a list of sentences. @param {{store: ArmingStore}} list */
function OpenPoints({ store: { reasons } }) {
  const count = reasons.value.length;
  return h(
    "section",
    { class: count ? "missing" : "missing ready", id: "missing", role: "status" },
    h("h2", {}, count ? t("arm-missing", { count }) : t("arm-ready")),
    count > 0 &&
      h(
        "ul",
        {},
        reasons.value.map((sentence) => h("li", { key: sentence }, sentence)),
      ),
  );
}

/** @param {{store: ArmingStore}} foot */
function Foot({ store: { reasons, isArming, arm, chooseVirtual } }) {
  const count = reasons.value.length;
  const isOff = isArming.value || count > 0;
  return h(
    Fragment,
    {},
    h("button", { type: "button", class: "btn", onClick: chooseVirtual }, t("chair-virtual")),
    h("span", { class: "grow" }, count ? t("arm-missing-short", { count }) : t("arm-front")),
    h(
      "button",
      {
        type: "button",
        class: "btn go large",
        "aria-describedby": "missing",
        "aria-disabled": isOff || undefined,
        onClick: () => void (isOff || arm()),
      },
      t(isArming.value ? "arm-busy" : "arm-go"),
    ),
  );
}
