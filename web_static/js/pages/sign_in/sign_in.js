/** Signing in by name and password. */
import { textLimits } from "../../reference.js";
import { h, put, set, write } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { passwordField } from "../../shell/password_field.js";
import { failureWords } from "../../api.js";
import { languageChoice } from "../../widgets/language_choice.js";
import { t } from "../../texts.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root */
export async function show(app, root) {
  const name = h("input", {
    type: "text",
    autocomplete: "username",
    required: true,
    ...textLimits("Credentials", "name"),
  });
  const password = h("input", { type: "password", autocomplete: "current-password", required: true });
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go large" }, t("sign-in-go"));
  const waiting = h("p", { class: "quiet", role: "status" });
  /** @param {boolean} is */
  const wait = (is) => {
    set(go, { "aria-disabled": is });
    write(waiting, is ? t("loading") : "");
  };
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (go.getAttribute("aria-disabled") === "true") return;
    problem.textContent = "";
    wait(true); // the password's hash alone takes a moment
    try {
      await app.signedIn(await app.api.post("/auth/sign-in", { name: name.value.trim(), password: password.value }));
    } catch (error) {
      problem.textContent = failureWords(error);
      wait(false);
    }
  };
  const form = h(
    "form",
    { class: "stack", onsubmit: submit },
    field(t("sign-in-name"), name),
    passwordField(t("sign-in-password"), password),
    problem,
    go,
    waiting,
  );
  put(
    root,
    h(
      "div",
      { class: "door card" },
      h("h1", { tabindex: "-1" }, t("sign-in-title")),
      h("p", { class: "lead" }, t("sign-in-lead")),
      app.me?.demo ? h("p", {}, t("sign-in-demo")) : [form, h("p", { class: "quiet small" }, t("sign-in-invited"))],
      languageChoice(app),
    ),
  );
}
