/**
 * The form that pairs a chair: what it is called, where it is, and what it may do.
 * @import { NewChair, PairedView, Speeds } from "types/api"
 * @import { Attributes } from "types/dom"
 */
import { limitsOf, numberLimits, REFERENCE, textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { field } from "../../widgets/fields.js";
import { speedRows } from "../../widgets/speed_rows.js";

/**
 * @param {import("../../main.js").App} app
 * @param {{onPaired: (answer: PairedView, chair: Required<NewChair>) => void, onClose: () => void}} then
 */
export function pairForm(app, { onPaired, onClose }) {
  /** @param {Attributes} more */
  const text = (more) => h("input", { type: "text", required: true, autocomplete: "off", ...more });
  const name = text(textLimits("NewChair", "name"));
  const host = text({ ...textLimits("NewChair", "host"), inputmode: "url", spellcheck: "false" });
  const port = h("input", {
    type: "number",
    required: true,
    ...numberLimits("NewChair", "port"),
    value: limitsOf("NewChair", "port").usual,
  });
  /** @type {Speeds} */
  const speeds = { ...REFERENCE.numbers.first_speeds };
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go" }, t("pair-go"));
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    go.disabled = true; // a second tap would pair a second chair
    const chair = { name: name.value.trim(), host: host.value.trim(), port: Number(port.value), speeds };
    try {
      onPaired(await app.api.post("/chairs", chair), chair);
    } catch (error) {
      problem.textContent = failureWords(error);
    }
    go.disabled = false;
  };
  return h(
    "form",
    { class: "pair-form stack", onsubmit: submit },
    h("h2", {}, t("pair-title")),
    h("p", { class: "quiet small" }, t("pair-lead")),
    field(t("pair-name"), name, t("pair-name-hint")),
    field(t("pair-host"), host, t("pair-host-hint")),
    field(t("pair-port"), port, t("pair-port-hint")),
    h(
      "details",
      {},
      h("summary", {}, t("pair-speeds")),
      h("p", { class: "quiet small" }, t("pair-speeds-hint")),
      speedRows(speeds, {}, (which, value) => (speeds[which] = value), { hasNumbers: true }).elements,
    ),
    problem,
    h("div", { class: "spread" }, go, h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel"))),
  );
}
