/**
 * The sign-off of a session: signing with a second tap, the history, and for an owner unlocking with a reason.
 * @import { RecordStore } from "./store.js"
 */
import { focusFirst, h, useOpenForm } from "../../preact.js";
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { moment } from "../../widgets/format.js";
import { mayWrite } from "./store.js";

/** @param {{store: RecordStore}} card */
export function SignOffCard({ store }) {
  const { me } = store.app;
  const { ended, sign_off: signed, sign_offs: all } = store.record.value;
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-sign")),
    signed
      ? h("p", {}, t("record-signed", { person: signed.person, moment: moment(signed.at) }))
      : h("p", { class: "quiet" }, t("record-sign-lead"), !ended && ` ${t("record-sign-ends")}`),
    signed ? me?.role === "owner" && h(Unlocking, { store }) : mayWrite(store.app) && h(Signing, { store }),
    all
      .filter(({ unlocked }) => unlocked)
      .map(({ person, at, unlocked, unlocked_by: owner, reason }) =>
        h(
          "p",
          { class: "quiet small", key: at },
          t("record-signed-past", { person, moment: moment(at), owner, unlocked: moment(unlocked), reason }),
        ),
      ),
  );
}

/** @param {{store: RecordStore}} buttons */
function Signing({ store: { app, record, change } }) {
  const { isOpen, open, close, buttonRef } = useOpenForm();
  const sign = async () => {
    if (await change(() => app.api.post(`/sessions/${record.value.id}/sign-off`), t("record-signed-done")))
      await app.toasts.attempt(() => app.readSession({ isOwn: true }));
  };
  if (!isOpen)
    return h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", ref: buttonRef, onClick: open }, t("record-sign-go")),
    );
  return h(
    "div",
    { class: "stack" },
    h("p", {}, t("record-sign-sure", { person: app.me?.name ?? "" })),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn go", ref: focusFirst, onClick: sign }, t("record-sign-yes")),
      h("button", { type: "button", class: "btn", onClick: close }, t("cancel")),
    ),
  );
}

/** @param {{store: RecordStore}} buttons */
function Unlocking({ store: { app, record, change } }) {
  const { isOpen, open, close, buttonRef } = useOpenForm();
  /** @param {SubmitEvent} event */
  const submit = (event) => {
    event.preventDefault();
    const entries = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    const reason = String(entries.get("reason")).trim();
    if (reason) change(() => app.api.post(`/sessions/${record.value.id}/unlock`, { reason }));
  };
  if (!isOpen)
    return h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", ref: buttonRef, onClick: open }, t("record-unlock")),
    );
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(
      Field,
      { label: t("record-unlock-reason"), hint: t("record-unlock-reason-hint") },
      h("input", {
        type: "text",
        name: "reason",
        required: true,
        ...textLimits("Unlock", "reason"),
        autocomplete: "off",
        ref: focusFirst,
      }),
    ),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn" }, t("record-unlock-yes")),
      h("button", { type: "button", class: "btn", onClick: close }, t("cancel")),
    ),
  );
}
