/** Why a trial does not count: a few reasons, or one's own. */
import { h, useLayoutEffect, useRef, useSignal } from "../preact.js";
import { textLimits } from "../reference.js";
import { t } from "../texts.js";
import { Choices, Field } from "../widgets/fields.js";

const REASONS = ["interrupted", "sensor", "practice", "other"];

/** @param {{onDiscard: (reason: string) => void, onClose: () => void}} form */
export function DiscardForm({ onDiscard, onClose }) {
  const chosen = useSignal(REASONS[0]);
  const words = useRef(/** @type {HTMLInputElement | null} */ (null));
  const isOther = chosen.value === "other";
  useLayoutEffect(() => {
    if (isOther) words.current?.focus();
  }, [isOther]);
  /** @param {SubmitEvent} event */
  const submit = (event) => {
    event.preventDefault();
    onDiscard(isOther ? (words.current?.value.trim() ?? "") : t(`over-discard-${chosen.value}`));
  };
  return h(
    "form",
    { class: "card discard", onSubmit: submit },
    h("h2", {}, t("over-discard-title")),
    h(Choices, {
      label: t("over-discard-title"),
      options: REASONS.map((value) => ({ value, label: t(`over-discard-${value}`) })),
      chosen: chosen.value,
      onChange: (reason) => (chosen.value = reason),
    }),
    h(
      "div",
      { hidden: !isOther },
      h(
        Field,
        { label: t("over-discard-other") },
        h("input", {
          type: "text",
          ...textLimits("Discard", "reason"),
          autocomplete: "off",
          required: isOther,
          ref: words,
        }),
      ),
    ),
    h(
      "div",
      { class: "spread" },
      h("button", { class: "btn go" }, t("over-discard-go")),
      h("button", { type: "button", class: "btn", onClick: onClose }, t("cancel")),
    ),
  );
}
