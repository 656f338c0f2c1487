/**
 * The sources of movements to choose from, each with its picture, what it needs and costs, how long it takes, and whether
 * it may drive a real chair.
 * @import { ShirtKind } from "types/documents"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { SourcePicture } from "./source_pictures.js";

/** @param {{kinds: ShirtKind[], chosen: string, onChoose: (kind: string) => void}} choices */
export function SourceChoices({ kinds, chosen, onChoose }) {
  /** @param {string} words @param {boolean} isSimulated */
  const group = (words, isSimulated) =>
    h(
      "div",
      { class: "source-cards", role: "group", "aria-label": words },
      h("h3", {}, words),
      kinds
        .filter(({ simulated }) => simulated === isSimulated)
        .map((one) =>
          h(SourceChoice, {
            key: one.kind,
            source: one,
            isChosen: one.kind === chosen,
            onChoose: () => onChoose(one.kind),
          }),
        ),
    );
  return h(
    "div",
    { class: "stack", role: "radiogroup", "aria-label": t("source-title") },
    group(t("source-worn"), false),
    group(t("source-practice"), true),
  );
}

/** @param {{source: ShirtKind, isChosen: boolean, onChoose: () => void}} choice */
function SourceChoice({ source: { kind, form, may_arm }, isChosen, onChoose }) {
  const [title, facts] = [`source_${kind}_title`, `source_${kind}_facts`];
  return h(
    "label",
    { class: "choice source-card" },
    h("input", {
      type: "radio",
      name: "source_kind",
      value: kind,
      checked: isChosen,
      onChange: onChoose,
      "aria-labelledby": title, // the facts are its description, not its name
      "aria-describedby": facts,
    }),
    h(SourcePicture, { kind }),
    h("b", { id: title }, form.title),
    h(
      "span",
      { class: "source-facts", id: facts },
      h("span", {}, form.description),
      form.facts && [
        h("span", { key: "needs" }, t("source-needs", { what: form.facts.needs })),
        h("span", { key: "costs" }, t("source-costs", { what: form.facts.costs })),
        h("span", { key: "takes" }, t("source-takes", { what: form.facts.takes })),
      ],
      h("span", {}, may_arm),
    ),
  );
}
