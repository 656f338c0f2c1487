/**
 * The form that pairs a chair: what it is called, where it is, and what it may do.
 * @import { NewChair, PairedView, Speeds } from "types/api"
 */
import { limitsOf, numberLimits, REFERENCE, textLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { focusFirst, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { SpeedRows } from "../../widgets/speed_rows.js";

/**
 * @param {object} form
 * @param {import("../../main.js").App} form.app
 * @param {(answer: PairedView, chair: Required<NewChair>) => void} form.onPaired @param {() => void} form.onClose
 */
export function PairForm({ app, onPaired, onClose }) {
  const problem = useSignal("");
  const isSending = useSignal(false); // a second tap would pair a second chair
  const speeds = useSignal(/** @type {Speeds} */ ({ ...REFERENCE.numbers.first_speeds }));
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.value) return;
    const entered = new FormData(/** @type {HTMLFormElement} */ (event.currentTarget));
    const [name, host] = ["name", "host"].map((field) => String(entered.get(field)).trim());
    const chair = { name, host, port: Number(entered.get("port")), speeds: speeds.value };
    problem.value = "";
    isSending.value = true;
    try {
      onPaired(await app.api.post("/chairs", chair), chair);
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };
  const usualPort = String(limitsOf("NewChair", "port").usual);
  const text = { type: "text", required: true, autocomplete: "off" };
  return h(
    "form",
    { class: "pair-form stack", onSubmit: submit },
    h("h2", {}, t("pair-title")),
    h("p", { class: "quiet small" }, t("pair-lead")),
    h(
      Field,
      { label: t("pair-name"), hint: t("pair-name-hint") },
      h("input", { name: "name", ...text, ...textLimits("NewChair", "name"), ref: focusFirst }),
    ),
    h(
      Field,
      { label: t("pair-host"), hint: t("pair-host-hint") },
      h("input", { name: "host", ...text, ...textLimits("NewChair", "host"), inputmode: "url", spellcheck: false }),
    ),
    h(
      Field,
      { label: t("pair-port"), hint: t("pair-port-hint", { port: usualPort }) },
      h("input", {
        name: "port",
        type: "number",
        required: true,
        ...numberLimits("NewChair", "port"),
        defaultValue: usualPort,
      }),
    ),
    h(
      "details",
      {},
      h("summary", {}, t("pair-speeds")),
      h("p", { class: "quiet small" }, t("pair-speeds-hint")),
      h(SpeedRows, {
        speeds: speeds.value,
        hasNumbers: true,
        onChange: (which, value) => (speeds.value = { ...speeds.value, [which]: value }),
      }),
    ),
    h("p", { class: "problem", role: "alert" }, problem),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go", "aria-disabled": isSending.value || undefined }, t("pair-go")),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
