/**
 * The page that an invitation opens: for whom it is, and the password that this person chooses.
 * @import { App } from "../../main.js"
 */
import { REFERENCE } from "../../reference.js";
import { failureWords } from "../../api.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { DoorForm } from "../../shell/door_form.js";
import { PasswordField } from "../../shell/password_field.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

/** @param {App} app @param {HTMLElement} root */
export async function show(app, root) {
  const code = app.invitation;
  try {
    const invited = await app.api.post("/auth/invitation", { code });
    drawPage(root, h(Door, { app, code, invited }), "door card");
  } catch (error) {
    const leave = () => leaveDoor(app);
    drawPage(
      root,
      h(
        Fragment,
        {},
        h("h1", { tabindex: -1 }, t("invitation-not")),
        h("p", { class: "lead", role: "alert" }, failureWords(error)),
        h("div", {}, h("button", { type: "button", class: "btn", onClick: leave }, t("invitation-leave"))),
      ),
      "door card stack",
    );
  }
}

/** @param {App} app */
function leaveDoor(app) {
  app.invitation = "";
  app.show();
}

/** @param {{app: App, code: string, invited: {name: string, role: string, is_new: boolean}}} door */
function Door({ app, code, invited: { name, role, is_new: isNew } }) {
  /** @param {Record<string, string>} typed */
  const send = async ({ password }) => {
    const me = await app.api.post("/auth/invitation/accept", { code, password });
    app.invitation = "";
    app.signedOut("");
    await app.signedIn(me);
  };
  const account = h("input", { type: "text", autocomplete: "username", value: name, readonly: true });
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t(isNew ? "invitation-title" : "invitation-again", { name })),
    h("p", { class: "lead" }, t(`people-role-${role}-about`)),
    app.me?.signed_in && h("p", { class: "small" }, t("invitation-signed-in", { name: app.me.name })),
    h(
      DoorForm,
      { action: t("invitation-go"), send },
      h(Field, { label: t("sign-in-name") }, account),
      h(PasswordField, {
        label: t("invitation-password"),
        hint: t("setup-password-hint", { count: REFERENCE.numbers.password_length }),
        autocomplete: "new-password",
      }),
    ),
  );
}
