/**
 * The learning curve as a card: the chart and what it says in plain words; statistics and the form of the curve in details.
 * @import { CurveForm, CurveModel, Learning, LearningCurve } from "types/documents"
 */
import { t } from "../../texts.js";
import { curveChart } from "../../charts/curve_chart.js";
import { h, put, write } from "../../widgets/dom.js";
import { segments } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { groupMark } from "../../results/source_group.js";

/** Of a measure that no trial has. @type {LearningCurve} */
const NO_CURVE = { text: "", sessions: null, details: [], fit: null, form: null, others: [] };
const CLEARLY_WORSE = 2; // of AICc; below it two curves describe the trials about as well

/**
 * @param {Learning} learning what GET /patients/ID/learning answered @param {string} measure
 * @param {(trial: number) => void} opens what a tap on a trial does @param {AbortSignal} signal
 */
export async function curveCard(learning, measure, opens, signal) {
  const curve = learning.curves[measure] ?? NO_CURVE;
  /** @type {CurveModel[]} the best first */
  const models = [{ form: curve.form, aicc_more: 0, ...curve.fit }, ...curve.others];
  const place = h("div", {});
  const words = h("p", { class: "small quiet", role: "status" });
  let drawn = new AbortController();
  signal.addEventListener("abort", () => drawn.abort());
  /** @param {CurveModel} model */
  const draw = async (model) => {
    drawn.abort();
    drawn = new AbortController();
    const { signal: until } = drawn;
    write(words, comparisonWords(model, models[0]));
    const made = await curveChart(learning, measure, model.value ? model : null, opens, until);
    if (!until.aborted && !signal.aborted) put(place, made);
  };
  /** @param {CurveForm} form */
  const choose = (form) => draw(models.find((model) => model.form === form) ?? models[0]);
  await draw(models[0]);
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("review-curve"), " ", groupMark(learning.source)),
    place,
    h("p", {}, curve.text),
    curve.sessions && h("p", {}, curve.sessions),
    learning.trials.length > 0 && h("p", { class: "small quiet" }, t("review-tap")),
    curve.details.length > 0 &&
      h(
        "details",
        { class: "small" },
        h("summary", {}, t("review-details")),
        segments(
          t("review-model"),
          models.flatMap(({ form }) => (form ? [{ value: form, label: t(`review-form-${form}`) }] : [])),
          models[0].form,
          choose,
        ),
        words,
        curve.details.map((sentence) => h("p", {}, sentence)),
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
