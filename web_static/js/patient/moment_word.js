/**
 * Which large word the patient's screen shows: rest, go, goal reached, finished.
 * A trial may end in any state of the chair, so its end is shown for END_FOR ms, as soon as nothing urgent is shown.
 */

const GO_FOR = 1600; // ms
const END_FOR = 8000; // ms

/**
 * @typedef {"" | "rest" | "go" | "goal" | "ended"} MomentWord
 * @typedef {Pick<import("../live/live.js").PatientMessage, "state" | "cue" | "trial" | "drives" | "over">} MomentMessage
 */

/** @returns {(now: MomentMessage, time: number) => MomentWord} takes each message, with the time at which it came (ms) */
export function momentWords() {
  /** @type {MomentMessage | null} */
  let before = null;
  let goUntil = -Infinity; // ms
  let endUntil = -Infinity; // ms
  return (now, time) => {
    if (before && now.over?.id !== before.over?.id) endUntil = time + END_FOR;
    if (before && now.state === "armed" && before.state !== "armed") goUntil = time + GO_FOR;
    // The trial that has ended is in the messages until it is measured; another one, or a drive, is the next.
    const isNextUnderWay = now.drives && now.trial?.id !== now.over?.id;
    if (isNextUnderWay) endUntil = -Infinity;
    before = now;
    if (now.state === "fault" || now.cue) return "";
    if (now.over && time < endUntil) return now.over.end === "goal" ? "goal" : "ended";
    if (now.state === "checking") return "rest";
    return now.state === "armed" && time < goUntil ? "go" : "";
  };
}
