/**
 * How often and how long a trial was interrupted: by the machine, by pauses for a slow screen, and by people.
 * @import { Measures } from "./measures.js"
 */
import { t } from "../texts.js";
import { number } from "../widgets/format.js";
import { measured } from "./measures.js";

const KINDS = /** @type {const} */ (["halts", "pauses", "person_stops"]);
const TIME = { halts: "halt_time", pauses: "pause_time", person_stops: "person_stop_time" };

/** "Halted 3 times, 14 s"; empty when nothing interrupted the trial. @param {Measures | null} measures */
export function interruptionWords(measures) {
  return KINDS.map((name) => {
    const count = measured(measures, name) ?? 0;
    return count ? t(`interruption-${name}`, { count, seconds: number(measured(measures, TIME[name]), 0) }) : "";
  })
    .filter(Boolean)
    .join(" · ");
}

/** Whether the machine interrupted a trial so much that a person has to say that it counts. @param {Measures | null} measures */
export function isInterrupted(measures) {
  return measures?.interrupted === true;
}
