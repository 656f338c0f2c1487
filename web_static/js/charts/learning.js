/**
 * What GET /patients/ID/learning answers. Its OpenAPI description leaves the fields of trials and curves open, because
 * they depend on the task.
 * @typedef {Omit<import("types/api").LearningView, "trials" | "curves"> & {trials: LearningTrial[], curves: Record<string, Curve>}} Learning
 */

/**
 * A trial with its measures by name.
 * @typedef {import("../results/measures.js").Measures & LearningFields} LearningTrial
 * @typedef {object} LearningFields
 * @property {number} number
 * @property {number} id
 * @property {number} session its number
 * @property {number} profile_version
 * @property {"calibration" | "adaptation" | "back"} origin of the profile version
 */

/**
 * The fitted curves of one measure.
 * @typedef {object} Curve
 * @property {string} text the trend in sentences
 * @property {string | null} sessions the changes within and between sessions, in sentences
 * @property {string | null} form "exponential", "power" or "level"
 * @property {Band | null} fit null where a level line is best
 * @property {CurveModel[]} others the other models, the better first
 *
 * @typedef {{n: number[], value: number[], low: number[], high: number[]}} Band a curve over the trials' numbers, with its
 *   95 % band
 * @typedef {Partial<Band> & {form: string | null, aicc_more: number}} CurveModel aicc_more: AICc above that of the best
 */

/** @param {import("types/api").LearningView} answer */
export function learningOf(answer) {
  return /** @type {Learning} */ (answer);
}
