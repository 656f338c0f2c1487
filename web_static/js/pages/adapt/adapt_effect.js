/**
 * What the last trial would have been like: the same movements, read by the map that is proposed.
 * @import { Effect } from "types/api"
 * @import { ComponentChildren } from "../../preact.js"
 */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { percent } from "../../widgets/format.js";

/** @param {{effect: Effect}} card effect: of a proposal */
export function EffectCard({ effect }) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("adapt-effect")),
    h(
      "dl",
      { class: "adapt-figures adapt-effect" },
      figure("alike", h("b", {}, percent(effect.alike))),
      figure("activations", change(effect.activations_before, effect.activations_after)),
      figure("false", change(effect.false_before, effect.false_after)),
    ),
    h("p", { class: "quiet small" }, t("adapt-effect-note")),
  );
}

/** @param {string} name @param {ComponentChildren} words */
function figure(name, words) {
  return h(
    "div",
    {},
    h("dt", { class: "quiet small" }, t(`adapt-effect-${name}`)),
    h("dd", { class: "number" }, words),
  );
}

/** @param {number} before @param {number} after */
function change(before, after) {
  return [before !== after && `${before} → `, h("b", {}, after)];
}
