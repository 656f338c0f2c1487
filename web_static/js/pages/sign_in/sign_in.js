/** Signing in by name and password. */
import { textLimits } from "../../reference.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { DoorForm } from "../../shell/door_form.js";
import { PasswordField } from "../../shell/password_field.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { LanguageChoice } from "../../widgets/language_choice.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root */
export async function show(app, root) {
  /** @param {Record<string, string>} typed */
  const send = async ({ name, password }) =>
    app.signedIn(await app.api.post("/auth/sign-in", { name: name.trim(), password }));
  const name = h("input", {
    type: "text",
    name: "name",
    autocomplete: "username",
    required: true,
    ...textLimits("Credentials", "name"),
  });
  const form = h(
    DoorForm,
    { action: t("sign-in-go"), send, hasStatus: true },
    h(Field, { label: t("sign-in-name") }, name),
    h(PasswordField, { label: t("sign-in-password"), autocomplete: "current-password" }),
  );
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("sign-in-title")),
      h("p", { class: "lead" }, t("sign-in-lead")),
      app.me?.demo ? h("p", {}, t("sign-in-demo")) : [form, h("p", { class: "quiet small" }, t("sign-in-invited"))],
      h(LanguageChoice, { app }),
    ),
    "door card",
  );
}
