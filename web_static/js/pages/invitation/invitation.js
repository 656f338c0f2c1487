/** The page that an invitation opens: for whom it is, and the password that this person chooses. */
import { REFERENCE } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { passwordField } from "../../shell/password_field.js";

/** @param {import("../../main.js").App} app @param {HTMLElement} root */
export async function show(app, root) {
  const code = app.invitation;
  try {
    put(root, door(app, code, await app.api.post("/auth/invitation", { code })));
  } catch (error) {
    const leave = () => leaveDoor(app);
    put(
      root,
      h(
        "div",
        { class: "door card stack" },
        h("h1", { tabindex: "-1" }, t("invitation-not")),
        h("p", { class: "lead", role: "alert" }, failureWords(error)),
        h("div", {}, h("button", { type: "button", class: "btn", onclick: leave }, t("invitation-leave"))),
      ),
    );
  }
}

/** @param {import("../../main.js").App} app */
function leaveDoor(app) {
  app.invitation = "";
  app.show();
}

/**
 * @param {import("../../main.js").App} app @param {string} code
 * @param {{name: string, role: string, is_new: boolean}} invited
 */
function door(app, code, { name, role, is_new: isNew }) {
  const account = h("input", { type: "text", autocomplete: "username", value: name, readonly: true });
  const password = h("input", { type: "password", autocomplete: "new-password", required: true });
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go large" }, t("invitation-go"));
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    go.disabled = true;
    try {
      const me = await app.api.post("/auth/invitation/accept", { code, password: password.value });
      app.invitation = "";
      app.signedOut("");
      await app.signedIn(me);
    } catch (error) {
      problem.textContent = failureWords(error);
    }
    go.disabled = false;
  };
  return h(
    "div",
    { class: "door card" },
    h("h1", { tabindex: "-1" }, t(isNew ? "invitation-title" : "invitation-again", { name })),
    h("p", { class: "lead" }, t(`people-role-${role}-about`)),
    app.me?.signed_in && h("p", { class: "small" }, t("invitation-signed-in", { name: app.me.name })),
    h(
      "form",
      { class: "stack", onsubmit: submit },
      field(t("sign-in-name"), account),
      passwordField(
        t("invitation-password"),
        password,
        t("setup-password-hint", { count: REFERENCE.numbers.password_length }),
      ),
      problem,
      go,
    ),
  );
}
