/** The change of the own password: it needs the old one, and signs this person out everywhere else. */
import { h, useRef, useSignal } from "../../preact.js";
import { REFERENCE } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

/** @param {{app: import("../../main.js").App}} card */
export function PasswordCard({ app }) {
  const old = useRef(/** @type {HTMLInputElement | null} */ (null));
  const chosen = useRef(/** @type {HTMLInputElement | null} */ (null));
  const problem = useSignal("");
  const isSending = useSignal(false);
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    const [before, after] = [old.current, chosen.current];
    if (!before || !after || isSending.value) return;
    problem.value = "";
    isSending.value = true;
    try {
      await app.api.put("/auth/password", { old: before.value, new: after.value });
      before.value = after.value = "";
      app.toasts.show(t("password-changed"));
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("password-title")),
    h("p", { class: "quiet small" }, t("password-lead", { name: app.me?.name })),
    h(
      "form",
      { class: "stack", onSubmit: submit },
      h(
        Field,
        { label: t("password-old") },
        h("input", { type: "password", autocomplete: "current-password", required: true, ref: old }),
      ),
      h(
        Field,
        { label: t("password-new"), hint: t("setup-password-hint", { count: REFERENCE.numbers.password_length }) },
        h("input", { type: "password", autocomplete: "new-password", required: true, ref: chosen }),
      ),
      h("p", { class: "problem", role: "alert" }, problem),
      h("div", {}, h("button", { class: "btn", "aria-disabled": isSending.value || undefined }, t("password-go"))),
    ),
  );
}
