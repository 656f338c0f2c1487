/** Why a trial does not count: a few reasons, or one's own. */
import { textLimits } from "../reference.js";
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { choices, field } from "../widgets/fields.js";

const REASONS = ["interrupted", "sensor", "practice", "other"];

/** @param {(reason: string) => void} onDiscard @param {() => void} onClose */
export function discardForm(onDiscard, onClose) {
  let chosen = REASONS[0];
  const words = h("input", { type: "text", ...textLimits("Discard", "reason"), autocomplete: "off" });
  const other = h("div", { hidden: true }, field(t("over-discard-other"), words));
  /** @param {string} reason */
  const choose = (reason) => {
    chosen = reason;
    other.hidden = reason !== "other";
    words.required = reason === "other";
    if (reason === "other") words.focus();
  };
  /** @param {SubmitEvent} event */
  const submit = (event) => {
    event.preventDefault();
    onDiscard(chosen === "other" ? words.value.trim() : t(`over-discard-${chosen}`));
  };
  return h(
    "form",
    { class: "card discard", onsubmit: submit },
    h("h2", {}, t("over-discard-title")),
    choices(
      t("over-discard-title"),
      REASONS.map((value) => ({ value, label: t(`over-discard-${value}`) })),
      chosen,
      choose,
    ),
    other,
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("over-discard-go")),
      h("button", { type: "button", class: "btn", onclick: onClose }, t("cancel")),
    ),
  );
}
