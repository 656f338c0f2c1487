/** The first start: the first owner is made with the code from the console. */
import { REFERENCE, textLimits } from "../../reference.js";
import { h, put } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { passwordField } from "../../shell/password_field.js";
import { failureWords } from "../../api.js";
import { languageChoice } from "../../widgets/language_choice.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root */
export async function show(app, root) {
  const link = /^#setup=(.+)$/.exec(location.hash);
  const code = h("input", {
    type: "text",
    autocomplete: "one-time-code",
    required: true,
    value: link ? decodeURIComponent(link[1]) : null,
  });
  if (link) history.replaceState(null, "", location.pathname);
  const name = h("input", {
    type: "text",
    autocomplete: "username",
    required: true,
    ...textLimits("FirstOwner", "name"),
  });
  const password = h("input", { type: "password", autocomplete: "new-password", required: true });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      const owner = { code: code.value.trim(), name: name.value.trim(), password: password.value };
      await app.signedIn(await app.api.post("/auth/setup", owner));
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  put(
    root,
    h(
      "div",
      { class: "door card" },
      h("h1", { tabindex: "-1" }, t("setup-title")),
      h("p", { class: "lead" }, t("setup-lead")),
      h(
        "form",
        { class: "stack", onsubmit: submit },
        field(t("setup-code"), code, t("setup-code-hint")),
        field(t("sign-in-name"), name),
        passwordField(
          t("sign-in-password"),
          password,
          t("setup-password-hint", { count: REFERENCE.numbers.password_length }),
        ),
        problem,
        h("button", { class: "btn go large" }, t("setup-go")),
      ),
      languageChoice(app),
    ),
  );
}
