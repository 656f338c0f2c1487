/** The goal of a session, in the patient's words. */
import { h, useSignal } from "../../preact.js";
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";

/** @param {{store: import("./store.js").RecordStore}} card */
export function GoalCard({ store: { app, record, mayChange, change } }) {
  const { id, goal } = record.value;
  const draft = useSignal(/** @type {string | null} */ (null)); // what was typed and not saved
  const title = h("h2", {}, t("record-goal"));
  if (!mayChange.value && draft.value === null)
    return h(
      "section",
      { class: "card" },
      title,
      h("p", { class: goal ? "own-words" : "quiet" }, goal || t("record-goal-none")),
    );
  const text = draft.value ?? goal;
  /** @param {{currentTarget: HTMLTextAreaElement}} event */
  const type = ({ currentTarget: { value } }) => (draft.value = value === goal ? null : value);
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (await change(() => app.api.put(`/sessions/${id}/goal`, { goal: text.trim() }), t("record-goal-saved")))
      draft.value = null;
  };
  return h(
    "form",
    { class: "card stack", onSubmit: submit },
    title,
    h(
      Field,
      { label: t("record-goal-hint") },
      h("textarea", { rows: 2, ...textLimits("Goal", "goal"), value: text, onInput: type }),
    ),
    h("div", { class: "spread" }, h("button", { class: "btn" }, t("record-goal-save"))),
  );
}
