/**
 * The goal of a session, in the patient's words.
 * @import { SessionRecordView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";

/** @param {import("../../main.js").App} app @param {() => SessionRecordView} now @param {import("./session.js").Writing} writing */
export function goalCard(app, now, { mayChange, change }) {
  const { id, goal } = now();
  const title = h("h2", {}, t("record-goal"));
  if (!mayChange)
    return h(
      "section",
      { class: "card" },
      title,
      h("p", { class: goal ? "own-words" : "quiet" }, goal || t("record-goal-none")),
    );
  const text = h("textarea", { rows: 2, ...textLimits("Goal", "goal") });
  text.defaultValue = text.value = goal;
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const written = text.value.trim();
    if (await change(() => app.api.put(`/sessions/${id}/goal`, { goal: written }), t("record-goal-saved")))
      text.defaultValue = text.value = written;
  };
  return h(
    "form",
    { class: "card stack", onsubmit: submit },
    title,
    field(t("record-goal-hint"), text),
    h("div", { class: "spread" }, h("button", { class: "btn" }, t("record-goal-save"))),
  );
}
