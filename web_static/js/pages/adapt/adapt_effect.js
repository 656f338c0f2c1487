/** What the last trial would have been like: the same movements, read by the map that is proposed. */
import { t } from "../../texts.js";
import { h } from "../../widgets/dom.js";
import { percent } from "../../widgets/format.js";

/** @param {any} effect of a proposal */
export function effectCard(effect) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("adapt.effect")),
    h(
      "dl",
      { class: "adapt-figures adapt-effect" },
      figure("alike", h("b", {}, percent(effect.alike))),
      figure("activations", change(effect.activations_before, effect.activations_after)),
      figure("false", change(effect.false_before, effect.false_after)),
    ),
    h("p", { class: "quiet small" }, t("adapt.effect.note")),
  );
}

function figure(name, words) {
  return h("div", {}, h("dt", { class: "quiet small" }, t(`adapt.effect.${name}`)), h("dd", { class: "number" }, words));
}

function change(before, after) {
  return before === after ? h("b", {}, String(after)) : [`${before} → `, h("b", {}, String(after))];
}
