/** Named sets: save what is set now under a name, come back to one that was saved. */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";

const LONGEST = 20; // characters, as wheelchair programming has it

/** @param {import("../../main.js").App} app @param {import("./controls_draft.js").ControlsDraft} draft */
export function setsCard(app, draft) {
  const { title } = draft.settings;
  const name = h("input", {
    type: "text",
    value: title,
    maxlength: Math.max(LONGEST, title.length),
    required: true,
    autocomplete: "off",
  });
  /** @param {SubmitEvent} event */
  const save = async (event) => {
    event.preventDefault();
    draft.setTitle(name.value.trim());
    await draft.flush();
    if (draft.view.parameters.title === name.value.trim())
      app.toasts.show(t("sets-saved", { title: name.value.trim() }));
  };
  /** @param {string} chosen */
  const load = (chosen) =>
    app.toasts.attempt(async () => {
      await draft.ask(() => draft.api.post("/controls/load", { title: chosen }));
      app.toasts.show(t("sets-loaded", { title: chosen }));
    });
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("sets-title")),
    h(
      "form",
      { class: "stack", onsubmit: save },
      draft.view.saved.length > 1 &&
        field(
          t("sets-load"),
          selection(
            draft.view.saved.map((one) => ({ value: one, label: one })),
            title,
            load,
          ),
        ),
      field(t("sets-name"), name),
      h("button", { class: "btn" }, t("sets-save")),
    ),
  );
}
