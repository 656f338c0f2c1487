/**
 * The learning curve as a card: the chart and what it says in plain words; statistics and the form of the curve in
 * details.
 * @import { CurveModel, LearningCurve } from "types/documents"
 * @import { PathReview } from "./store.js"
 */
import { ChartPlace } from "../../charts/chart_place.js";
import { curveChart } from "../../charts/curve_chart.js";
import { h, useSignal } from "../../preact.js";
import { GroupMark } from "../../results/source_group.js";
import { t } from "../../texts.js";
import { Segments } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";

/** Of a measure that no trial has. @type {LearningCurve} */
const NO_CURVE = { text: "", sessions: null, details: [], fit: null, form: null, others: [] };
const CLEARLY_WORSE = 2; // of AICc; below it two curves describe the trials about as well

/** @param {{app: import("../../main.js").App, left: AbortSignal, patient: {id: number}, review: PathReview}} card */
export function CurveCard({ app, left, patient, review: { learning, measure } }) {
  const curve = learning.curves[measure] ?? NO_CURVE;
  /** @type {CurveModel[]} the best first */
  const models = [{ form: curve.form, aicc_more: 0, ...curve.fit }, ...curve.others];
  const [best] = models;
  const chosen = useSignal(/** @type {string | null} */ (null)); // the form that somebody has chosen
  const model = models.find(({ form }) => form === chosen.value) ?? best;
  /** A tap on a trial opens it. @param {number} trial id */
  const open = (trial) => app.go(`#/review/${patient.id}/trial/${trial}`);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("review-curve"), " ", h(GroupMark, { group: learning.source })),
    h(ChartPlace, {
      app,
      left,
      of: [learning, measure, model.form],
      make: (until) => curveChart(learning, measure, model.value ? model : null, open, until),
    }),
    h("p", {}, curve.text),
    curve.sessions && h("p", {}, curve.sessions),
    h("p", { class: "small quiet" }, t("review-tap")),
    curve.details.length > 0 &&
      h(
        "details",
        { class: "small" },
        h("summary", {}, t("review-details")),
        h(Segments, {
          label: t("review-model"),
          options: models.flatMap(({ form }) => (form ? [{ value: form, label: t(`review-form-${form}`) }] : [])),
          chosen: model.form ?? "",
          onChange: (form) => void (chosen.value = form),
        }),
        h("p", { class: "small quiet", role: "status" }, comparisonWords(model, best)),
        curve.details.map((sentence) => h("p", { key: sentence }, sentence)),
      ),
  );
}

/** How a curve describes the trials beside the best one. @param {CurveModel} model @param {CurveModel} best */
function comparisonWords(model, best) {
  if (model === best) return "";
  const worse = model.aicc_more < CLEARLY_WORSE ? "review-model-as-well" : "review-model-worse";
  return t(worse, {
    model: t(`review-form-${model.form}`),
    best: t(`review-form-within-${best.form}`),
    amount: number(model.aicc_more, 1),
  });
}
