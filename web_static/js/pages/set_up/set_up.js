/** The first start: the first owner is made with the code from the console. */
import { REFERENCE, textLimits } from "../../reference.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { DoorForm } from "../../shell/door_form.js";
import { PasswordField } from "../../shell/password_field.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { LanguageChoice } from "../../widgets/language_choice.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root */
export async function show(app, root) {
  const link = /^#setup=(.+)$/.exec(location.hash);
  if (link) history.replaceState(null, "", location.pathname);
  /** @param {Record<string, string>} typed */
  const send = async ({ code, name, password }) => {
    const owner = { code: code.trim(), name: name.trim(), password };
    await app.signedIn(await app.api.post("/auth/setup", owner));
  };
  const code = h("input", {
    type: "text",
    name: "code",
    autocomplete: "one-time-code",
    required: true,
    defaultValue: link ? decodeURIComponent(link[1]) : "",
  });
  const name = h("input", {
    type: "text",
    name: "name",
    autocomplete: "username",
    required: true,
    ...textLimits("FirstOwner", "name"),
  });
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("setup-title")),
      h("p", { class: "lead" }, t("setup-lead")),
      h(
        DoorForm,
        { action: t("setup-go"), send },
        h(Field, { label: t("setup-code"), hint: t("setup-code-hint") }, code),
        h(Field, { label: t("sign-in-name") }, name),
        h(PasswordField, {
          label: t("sign-in-password"),
          hint: t("setup-password-hint", { count: REFERENCE.numbers.password_length }),
          autocomplete: "new-password",
        }),
      ),
      h(LanguageChoice, { app }),
    ),
    "door card",
  );
}
