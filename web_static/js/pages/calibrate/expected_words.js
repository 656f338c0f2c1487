/**
 * What is expected of a map learnt from other people, in sentences.
 * @import { Forecast, PriorResult } from "types/documents"
 */
import { t } from "../../texts.js";
import { number } from "../../widgets/format.js";

/** Hits of 100 movements and false activations a minute; each says so where it is not known. @param {Pick<PriorResult, "hits" | "false_per_minute">} prior */
export function expectedWords({ hits, false_per_minute: falsely }) {
  return [words("hits", hits, 0), words("false", falsely, 1)];
}

/** @param {"hits" | "false"} what @param {Forecast | null} forecast @param {number} digits */
function words(what, forecast, digits) {
  if (!forecast) return t(`result.expected.${what}.none`);
  return t(`result.expected.${what}`, { value: number(forecast.value, digits), uncertainty: number(forecast.uncertainty, digits) });
}
