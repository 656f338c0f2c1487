/** The change of the own password: it needs the old one, and signs this person out everywhere else. */
import { REFERENCE } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app */
export function passwordCard(app) {
  const old = h("input", { type: "password", autocomplete: "current-password", required: true });
  const chosen = h("input", { type: "password", autocomplete: "new-password", required: true });
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn" }, t("password-go"));
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    go.disabled = true;
    try {
      await app.api.put("/auth/password", { old: old.value, new: chosen.value });
      old.value = chosen.value = "";
      app.toasts.show(t("password-changed"));
    } catch (error) {
      problem.textContent = failureWords(error);
    }
    go.disabled = false;
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("password-title")),
    h("p", { class: "quiet small" }, t("password-lead", { name: app.me?.name })),
    h(
      "form",
      { class: "stack", onsubmit: submit },
      field(t("password-old"), old),
      field(t("password-new"), chosen, t("setup-password-hint", { count: REFERENCE.numbers.password_length })),
      problem,
      h("div", {}, go),
    ),
  );
}
