/**
 * The outcome scales of a session: name, total and date of each.
 * @import { ScaleView } from "types/api"
 * @import { RecordStore } from "./store.js"
 */
import { passFocus } from "../../focus.js";
import { h, useRef, useSignal } from "../../preact.js";
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { day, today, unrounded } from "../../widgets/format.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

/** @param {{store: RecordStore}} card */
export function ScalesCard({ store }) {
  const { scales } = store.record.value;
  const columns = [t("record-scale-name"), t("record-scale-total"), t("record-scale-day")];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-scales")),
    scales.length
      ? h(
          ScrollTable,
          { label: t("record-scales"), kind: "measures" },
          h(TableHead, { columns }, store.mayChange.value && h("td", {})),
          h(
            "tbody",
            {},
            scales.map((scale) => h(Row, { key: scale.id, scale, store })),
          ),
        )
      : h("p", { class: "quiet" }, t("record-scales-none")),
    h(NewScale, { store }),
  );
}

/** @param {{scale: ScaleView, store: RecordStore}} row */
function Row({ scale: { id, name, total, day: of }, store: { app, record, mayChange, change } }) {
  const remove = {
    type: /** @type {const} */ ("button"),
    class: "btn small",
    "aria-label": t("record-scale-remove-label", { name, day: day(of) }),
    ref: passFocus,
    onClick: () => change(() => app.api.remove(`/sessions/${record.value.id}/scales/${id}`)),
  };
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, name),
    h("td", {}, unrounded(total)),
    h("td", {}, day(of)),
    mayChange.value && h("td", {}, h("button", remove, t("record-scale-remove"))),
  );
}

/** @param {{store: RecordStore}} form */
function NewScale({ store: { app, record, mayChange, change } }) {
  const draft = useSignal({ name: "", total: "", day: today() });
  const problem = useSignal("");
  const nameInput = useRef(/** @type {HTMLInputElement | null} */ (null));
  const totalInput = useRef(/** @type {HTMLInputElement | null} */ (null));
  const { name, total, day: date } = draft.value;
  if (!mayChange.value && !name && !total) return null;
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const value = Number(total.trim().replace(",", "."));
    problem.value = Number.isFinite(value) ? "" : t("record-scale-total-missing");
    if (problem.value) return totalInput.current?.focus();
    const scale = { name: name.trim(), total: value, day: date };
    if (!(await change(() => app.api.post(`/sessions/${record.value.id}/scales`, scale)))) return;
    draft.value = { ...draft.value, name: "", total: "" };
    nameInput.current?.focus();
  };
  /** The attributes that tie an input to the draft. @param {keyof typeof draft.value} part */
  const tied = (part) => ({
    required: true,
    value: draft.value[part],
    onInput: (/** @type {Event} */ { currentTarget }) => {
      draft.value = { ...draft.value, [part]: /** @type {HTMLInputElement} */ (currentTarget).value };
    },
  });
  const text = { type: /** @type {const} */ ("text"), autocomplete: /** @type {const} */ ("off") };
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(
      "div",
      { class: "columns" },
      h(
        Field,
        { label: t("record-scale-name"), hint: t("record-scale-name-hint") },
        h("input", { ...text, ...textLimits("NewScale", "name"), ref: nameInput, ...tied("name") }),
      ),
      h(
        Field,
        { label: t("record-scale-total"), hint: t("record-scale-total-hint") },
        h("input", { ...text, inputmode: "decimal", ref: totalInput, ...tied("total") }),
      ),
      h(Field, { label: t("record-scale-day") }, h("input", { type: "date", ...tied("day") })),
    ),
    h("p", { class: "problem", role: "alert" }, problem.value),
    h("div", { class: "spread" }, h("button", { class: "btn" }, t("record-scale-add"))),
  );
}
