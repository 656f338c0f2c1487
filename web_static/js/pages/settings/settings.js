/** Settings: what the owner allows here, and the chairs and screens that are paired. Others see them, and change nothing. */
import { ChairsCard } from "./chairs_card.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { LanguageChoice, languagesOf } from "../../widgets/language_choice.js";
import { LimitsCard } from "./limits_card.js";
import { PasswordCard } from "./password_card.js";
import { PatientScreenCard, screenStore } from "../../widgets/patient_screen_card.js";
import { PriorCard } from "./prior_card.js";
import { t } from "../../texts.js";
import { TabletsCard } from "./tablets_card.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const role = app.me?.role;
  const [clinic, chairs, prior, screens] = await Promise.all([
    app.api.get("/limits"),
    app.api.get("/chairs"),
    app.api.get("/clinic-prior"),
    role !== "reviewer" && screenStore(app, left),
  ]);
  if (left.aborted) return;
  const isOwner = role === "owner";
  const right = h(
    "div",
    { class: "stack" },
    h(ChairsCard, { app, first: chairs, isOwner, left }),
    h(TabletsCard, { app, left }),
    screens && h(PatientScreenCard, { store: screens }),
    role !== "reviewer" && h(PriorCard, { app, first: prior, isOwner }),
    role !== "reviewer" && linkedCard("plans-settings-lead", "plans-settings", "#/plans", "plans-link"),
    isOwner && linkedCard("people-settings-lead", "rail-people", "#/people", "people-settings-go"),
    isOwner && linkedCard("log-lead", "rail-log", "#/log", "log-settings-go"),
    isOwner && linkedCard("computer-lead", "rail-computer", "#/computer", "computer-settings-go"),
    isOwner && linkedCard("backup-lead", "rail-backup", "#/backup", "backup-settings-go"),
    languagesOf(app).length > 0 && languageCard(app),
    !app.me?.demo && h(PasswordCard, { app }),
  );
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("settings-title")),
      h("p", { class: "lead" }, t("settings-lead"), !isOwner && ` ${t("settings-read-only")}`),
      h("div", { class: "settings-columns" }, h(LimitsCard, { app, first: clinic, isOwner, left }), right),
    ),
  );
}

/** @param {import("../../main.js").App} app */
function languageCard(app) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("language-title")),
    h("p", { class: "quiet small" }, t("language-lead")),
    h(LanguageChoice, { app }),
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
