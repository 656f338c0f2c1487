/**
 * What is expected of a map learnt from other people, in sentences.
 * @import { Forecast, MapResult } from "types/documents"
 */
import { t } from "../../texts.js";
import { number } from "../../widgets/format.js";

/**
 * Hits of 100 movements and false activations a minute; each says so where it is not known. Then what prompts would bring.
 * @param {Pick<MapResult, "hits" | "hits_with_prompts" | "false_per_minute">} prior
 */
export function expectedWords({ hits, hits_with_prompts: more, false_per_minute: falsely }) {
  const said = [words("hits", hits, 0), words("false", falsely, 1)];
  return more ? [...said, words("prompted", more, 0)] : said;
}

/** @param {"hits" | "false" | "prompted"} what @param {Forecast | null} forecast @param {number} digits */
function words(what, forecast, digits) {
  if (!forecast) return t(`result-expected-${what}-none`);
  return t(`result-expected-${what}`, {
    value: number(forecast.value, digits),
    uncertainty: number(forecast.uncertainty, digits),
  });
}
