/**
 * What the notices of a stop or fault follow: its words, each further stop during it, and how it is read out.
 * @import { FaultMessage } from "types/api"
 */
import { t } from "../texts.js";
import { timeOfDay } from "../widgets/format.js";

const ONE_PRESS = 400; // ms within which two stops are those of one press

/**
 * @typedef {object} Further
 * @property {string} key changes with each further stop, so that the notice is read out again
 * @property {string} again that somebody stopped again since the first reason, and when; empty when nobody did
 * @typedef {FaultMessage & Further} Halt
 */

/**
 * Return what tells the halt of now: the fault with its further stops, null when there is no fault. The second stop of
 * one press, which is sent in two ways, is no further one.
 * @returns {<Fault extends {name: string}>(fault: Fault | null | undefined, stops: number) => (Fault & Further) | null}
 */
export function haltFollower() {
  let [counted, presses, since, again, isHalted] = [-1, 0, -Infinity, "", false];
  return (fault, stops) => {
    if (!fault) {
      [again, isHalted] = ["", false];
      return null;
    }
    const now = performance.now();
    if (stops !== counted && now - since > ONE_PRESS) {
      [presses, since] = [presses + 1, now];
      if (isHalted) again = t("note-fault-again", { time: timeOfDay(Date.now()) });
    }
    [counted, isHalted] = [stops, true];
    return { ...fault, key: `fault ${fault.name} ${presses}`, again };
  };
}

/** How a screen reader says it: a stop at once, anything else after what it is saying. @param {{name: string, again?: string} | null | undefined} halt */
export function urgency(halt) {
  return halt?.again || halt?.name.toLowerCase().startsWith("stop") ? "assertive" : "polite";
}
