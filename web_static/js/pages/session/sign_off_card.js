/**
 * The sign-off of a session: signing with a second tap, the history, and for an owner unlocking with a reason.
 * @import { SessionRecordView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { moment } from "../../widgets/format.js";

/** @param {import("../../main.js").App} app @param {SessionRecordView} record @param {import("./session.js").Writing} writing */
export function signOffCard(app, record, { mayChange, isOwner, person, change }) {
  const { id, ended, sign_off: signed, sign_offs: all } = record;
  const place = h("div", { class: "stack" });
  const past = all.filter(({ unlocked }) => unlocked);
  const ask = () => {
    const yes = async () => {
      if (await change(() => app.api.post(`/sessions/${id}/sign-off`), t("record-signed-done")))
        await app.toasts.attempt(() => app.readSession({ isOwn: true }));
    };
    put(
      place,
      h("p", {}, t("record-sign-sure", { person })),
      h(
        "div",
        { class: "spread" },
        h("button", { type: "button", class: "btn go", onclick: yes }, t("record-sign-yes")),
        h("button", { type: "button", class: "btn", onclick: offer }, t("cancel")),
      ),
    );
    place.querySelector("button")?.focus();
  };
  const offer = () =>
    put(
      place,
      h(
        "div",
        { class: "spread" },
        h("button", { type: "button", class: "btn go", onclick: ask }, t("record-sign-go")),
      ),
    );
  const askWhy = () => {
    put(
      place,
      unlockForm((reason) => change(() => app.api.post(`/sessions/${id}/unlock`, { reason })), offerUnlock),
    );
    place.querySelector("input")?.focus();
  };
  const offerUnlock = () =>
    put(
      place,
      h("div", { class: "spread" }, h("button", { type: "button", class: "btn", onclick: askWhy }, t("record-unlock"))),
    );
  if (signed && isOwner) offerUnlock();
  else if (!signed && mayChange) offer();
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-sign")),
    signed && h("p", {}, t("record-signed", { person: signed.person, moment: moment(signed.at) })),
    !signed && h("p", { class: "quiet" }, t("record-sign-lead"), !ended && ` ${t("record-sign-ends")}`),
    place,
    past.map(({ person: by, at, unlocked, unlocked_by: owner, reason }) =>
      h(
        "p",
        { class: "quiet small" },
        t("record-signed-past", { person: by, moment: moment(at), owner, unlocked: moment(unlocked), reason }),
      ),
    ),
  );
}

/** @param {(reason: string) => Promise<boolean>} send @param {() => void} onClose */
function unlockForm(send, onClose) {
  const reason = h("input", { type: "text", required: true, ...textLimits("Unlock", "reason"), autocomplete: "off" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (reason.value.trim()) await send(reason.value.trim());
  };
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    field(t("record-unlock-reason"), reason, t("record-unlock-reason-hint")),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn" }, t("record-unlock-yes")),
      h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel")),
    ),
  );
}
