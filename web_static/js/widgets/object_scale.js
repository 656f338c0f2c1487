/** The question about a 3D object whose size is improbable in metres: a person chooses its size, or cancels. */
import { ApiError } from "../api.js";
import { t } from "../texts.js";
import { significant } from "./format.js";
import { ask } from "./question.js";

/**
 * Send an object; when its size is improbable, ask and send it again.
 * @template Answer
 * @param {HTMLElement} place the page frame's, as of `questionPlace`
 * @param {(metresPerUnit: string) => Promise<Answer>} send with the part of the address that says how long its unit is
 * @returns {Promise<Answer | null>} the answer; null when the person cancelled
 */
export async function sendInMetres(place, send) {
  try {
    return await send("");
  } catch (error) {
    if (!(error instanceof ApiError && error.choice && "scales" in error.choice)) throw error;
    const answers = error.choice.scales.map(({ metres_per_unit: scale, size }) => ({
      value: String(scale),
      label: t(scale === 1 ? "object-scale-as-it-says" : "object-scale-size", { size: sizeWords(size) }),
    }));
    const chosen = await ask(place, error.message, [...answers, { value: null, label: t("cancel") }]);
    return chosen === null ? null : send(`&metres_per_unit=${chosen}`);
  }
}

/** Length, width and height with three digits each. @param {number[]} size m */
const sizeWords = (size) => size.map((side) => significant(side, 3)).join(" × ");
