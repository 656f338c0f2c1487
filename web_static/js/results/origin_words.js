/**
 * Where an imported session or trial came from, in words.
 * @import { OriginView } from "types/api"
 */
import { t } from "../texts.js";
import { moment } from "../widgets/format.js";

/** "" for what was done in this clinic. @param {OriginView | null | undefined} origin */
export function originWords(origin) {
  return origin ? t("origin-words", { clinic: origin.clinic, person: origin.person, moment: moment(origin.at) }) : "";
}
