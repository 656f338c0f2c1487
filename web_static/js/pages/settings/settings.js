/** Settings: what the owner allows here, and the chairs and screens that are paired. Others see them, and change nothing. */
import { chairsCard } from "./chairs_card.js";
import { h, put } from "../../widgets/dom.js";
import { languageChoice } from "../../widgets/language_choice.js";
import { limitsCard } from "./limits_card.js";
import { passwordCard } from "./password_card.js";
import { patientScreenCard } from "../../widgets/patient_screen_card.js";
import { priorCard } from "./prior_card.js";
import { t } from "../../texts.js";
import { tabletsCard } from "./tablets_card.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const role = app.me?.role;
  const [clinic, chairs, prior, screens] = await Promise.all([
    app.api.get("/limits"),
    app.api.get("/chairs"),
    app.api.get("/clinic-prior"),
    role !== "reviewer" && patientScreenCard(app, signal),
  ]);
  if (signal.aborted) return;
  const isOwner = role === "owner";
  const limits = limitsCard(app, clinic, isOwner, signal);
  const right = [
    chairsCard(app, chairs, isOwner, signal),
    tabletsCard(app, signal),
    screens,
    role !== "reviewer" && priorCard(app, prior, isOwner),
    role !== "reviewer" && linkedCard("plans-settings-lead", "plans-settings", "#/plans", "plans-link"),
    isOwner && linkedCard("people-settings-lead", "rail-people", "#/people", "people-settings-go"),
    isOwner && linkedCard("log-lead", "rail-log", "#/log", "log-settings-go"),
    isOwner && linkedCard("computer-lead", "rail-computer", "#/computer", "computer-settings-go"),
    isOwner && linkedCard("backup-lead", "rail-backup", "#/backup", "backup-settings-go"),
    languageCard(app),
    !app.me?.demo && passwordCard(app),
  ];
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("settings-title")),
      h("p", { class: "lead" }, t("settings-lead"), !isOwner && ` ${t("settings-read-only")}`),
      h("div", { class: "settings-columns" }, limits, h("div", { class: "stack" }, right)),
    ),
  );
}

/** @param {import("../../main.js").App} app */
function languageCard(app) {
  const choice = languageChoice(app);
  return (
    choice &&
    h(
      "section",
      { class: "card" },
      h("h2", {}, t("language-title")),
      h("p", { class: "quiet small" }, t("language-lead")),
      choice,
    )
  );
}

/** A card that leads to a page of its own; each argument but the address is the key of a text. @param {string} lead @param {string} title @param {string} hash @param {string} link */
function linkedCard(lead, title, hash, link) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t(title)),
    h("p", { class: "quiet small" }, t(lead)),
    h("a", { class: "btn small", href: hash }, t(link)),
  );
}
