/** Settings: what the owner allows here, and the chairs and screens that are paired. Others see them, and change nothing. */
import { chairsCard } from "./chairs_card.js";
import { h, put } from "../../widgets/dom.js";
import { limitsCard } from "./limits_card.js";
import { logCard } from "./log_card.js";
import { patientScreenCard } from "../../widgets/patient_screen_card.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const [clinic, chairs] = await Promise.all([app.api.get("/limits"), app.api.get("/chairs")]);
  if (signal.aborted) return;
  const role = app.me?.role;
  const isOwner = role === "owner";
  const limits = limitsCard(app, clinic, isOwner, signal);
  const right = [
    chairsCard(app, chairs, isOwner, signal),
    role !== "reviewer" && patientScreenCard(app, signal),
    role !== "reviewer" && plansCard(),
    isOwner && logCard(app, signal),
  ];
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("settings.title")),
      h("p", { class: "lead" }, t("settings.lead"), !isOwner && ` ${t("settings.read-only")}`),
      h("div", { class: "settings-columns" }, limits, h("div", { class: "stack" }, right)),
    ),
  );
}

function plansCard() {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("plans.settings")),
    h("p", { class: "quiet small" }, t("plans.settings.lead")),
    h("a", { class: "btn small", href: "#/plans" }, t("plans.link")),
  );
}
