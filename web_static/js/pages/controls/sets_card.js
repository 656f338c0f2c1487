/** Named sets: save what is set now under a name, come back to one that was saved. */
import { h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";

const LONGEST = 20; // characters, as wheelchair programming has it

/** @param {{store: import("./store.js").ControlsStore}} card */
export function SetsCard({ store }) {
  const { toasts } = store.app;
  const { saved, parameters } = store.view.value;
  const { title } = store.settings.value;
  const draft = useSignal(/** @type {string | null} */ (null)); // null: the name of the set in use
  const name = draft.value ?? title;
  /** @param {SubmitEvent} event */
  const save = async (event) => {
    event.preventDefault();
    const chosen = name.trim();
    if (!(await store.save(chosen))) return;
    if (draft.value === name) draft.value = null;
    toasts.show(t("sets-saved", { title: chosen }));
  };
  /** @param {string} chosen */
  const load = (chosen) =>
    toasts.attempt(async () => {
      await store.load(chosen);
      draft.value = null;
      toasts.show(t("sets-loaded", { title: chosen }));
    });
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("sets-title")),
    h(
      "form",
      { class: "stack", onSubmit: save },
      saved.length > 1 &&
        h(
          Field,
          { label: t("sets-load") },
          h(Selection, {
            options: saved.map((one) => ({ value: one, label: one })),
            chosen: parameters.title,
            onChange: load,
          }),
        ),
      h(
        Field,
        { label: t("sets-name") },
        h("input", {
          type: "text",
          defaultValue: title, // what differs from it is a name that was not saved
          value: name,
          maxlength: Math.max(LONGEST, title.length),
          required: true,
          autocomplete: "off",
          onInput: (/** @type {Event} */ { currentTarget }) =>
            void (draft.value = /** @type {HTMLInputElement} */ (currentTarget).value),
        }),
      ),
      h("button", { class: "btn" }, t("sets-save")),
    ),
  );
}
