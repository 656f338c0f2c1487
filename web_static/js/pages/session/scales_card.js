/**
 * The outcome scales of a session: name, total and date of each.
 * @import { ScaleView, SessionRecordView } from "types/api"
 */
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { day, unrounded } from "../../widgets/format.js";
import { scrollTable } from "../../widgets/scroll_table.js";

/** @param {import("../../main.js").App} app @param {() => SessionRecordView} now @param {import("./session.js").Writing} writing */
export function scalesCard(app, now, { mayChange, change }) {
  const { id } = now();
  const list = h("div", {});
  /** @param {ScaleView} scale */
  const row = (scale) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, scale.name),
      h("td", {}, unrounded(scale.total)),
      h("td", {}, day(scale.day)),
      mayChange && h("td", {}, removeButton(scale)),
    );
  /** @param {ScaleView} scale */
  const removeButton = (scale) => {
    const label = t("record-scale-remove-label", { name: scale.name, day: day(scale.day) });
    const remove = async () => {
      if (await change(() => app.api.remove(`/sessions/${id}/scales/${scale.id}`))) draw();
    };
    return h(
      "button",
      { type: "button", class: "btn small", "aria-label": label, onclick: remove },
      t("record-scale-remove"),
    );
  };
  const draw = () => {
    const { scales } = now();
    const head = [t("record-scale-name"), t("record-scale-total"), t("record-scale-day")];
    put(
      list,
      scales.length === 0
        ? h("p", { class: "quiet" }, t("record-scales-none"))
        : scrollTable(
            t("record-scales"),
            "measures",
            h(
              "thead",
              {},
              h(
                "tr",
                {},
                head.map((words) => h("th", { scope: "col" }, words)),
                mayChange && h("td", {}),
              ),
            ),
            h("tbody", {}, scales.map(row)),
          ),
    );
  };
  draw();
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("record-scales")),
    list,
    mayChange && newScale(app, id, change, draw),
  );
}

/** @param {import("../../main.js").App} app @param {number} id of the session @param {import("./session.js").Writing["change"]} change @param {() => void} onAdded */
function newScale(app, id, change, onAdded) {
  const name = h("input", { type: "text", required: true, ...textLimits("NewScale", "name"), autocomplete: "off" });
  const total = h("input", { type: "text", inputmode: "decimal", required: true, autocomplete: "off" });
  const date = h("input", { type: "date", required: true });
  date.defaultValue = date.value = today();
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    const value = Number(total.value.trim().replace(",", "."));
    problem.textContent = Number.isFinite(value) ? "" : t("record-scale-total-missing");
    if (problem.textContent) return total.focus();
    const scale = { name: name.value.trim(), total: value, day: date.value };
    if (!(await change(() => app.api.post(`/sessions/${id}/scales`, scale)))) return;
    for (const input of [name, total]) input.value = "";
    name.focus();
    onAdded();
  };
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    h(
      "div",
      { class: "columns" },
      field(t("record-scale-name"), name, t("record-scale-name-hint")),
      field(t("record-scale-total"), total, t("record-scale-total-hint")),
      field(t("record-scale-day"), date),
    ),
    problem,
    h("div", { class: "spread" }, h("button", { class: "btn" }, t("record-scale-add"))),
  );
}

/** Today, as an input of a date takes it. */
export function today() {
  const now = new Date();
  return new Date(now.getTime() - now.getTimezoneOffset() * 60_000).toISOString().slice(0, 10);
}
