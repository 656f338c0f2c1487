/** The large cue of a calibration: the words, legible from 2 m, and a ring that fills with the time of the cue. */
import { h, s, set, write } from "../widgets/dom.js";
import { discRadius, ringShare } from "../widgets/cue_circle.js";
import { t } from "../texts.js";

const RADIUS = 118;
const ROUND = 2 * Math.PI * RADIUS;
const FURTHEST = 0.3; // s for which the ring goes on without a message; then it stops, because the run may have stopped too
const COUNTED = new Set(["ready", "rest", "free"]); // whole seconds; the others are too short to be counted

/**
 * @typedef {import("../live/live.js").Live<import("../live/live.js").PatientMessage>} PatientLive
 * @typedef {import("types/api").PatientCue} PatientCue
 */

/** The words of a cue. @param {Pick<PatientCue, "kind" | "movement">} cue */
export function cueWords({ kind, movement }) {
  return kind === "move" && movement ? movement : t(`patient-cue-${kind}`);
}

/** @param {PatientLive} live @param {AbortSignal} signal */
export function cueLayer(live, signal) {
  const disc = s("circle", { class: "disc", cx: 150, cy: 150, r: discRadius("rest", 0) });
  const ring = s("circle", { class: "ring", cx: 150, cy: 150, r: RADIUS, transform: "rotate(-90 150 150)" });
  const seconds = s("text", { class: "seconds", x: 150, y: 172, "text-anchor": "middle" });
  const track = s("circle", { class: "track", cx: 150, cy: 150, r: RADIUS });
  const picture = s("svg", { viewBox: "0 0 300 300", "aria-hidden": "true" }, track, disc, ring, seconds);
  const words = h("p", { class: "cue-words", role: "status" });
  const then = h("p", { class: "cue-then" });
  const element = h("div", { class: "cue-layer", hidden: true }, picture, words, then);

  /** @param {PatientCue} cue */
  const draw = (cue) => {
    const time = Math.min(cue.length, cue.t + Math.min(live.age, FURTHEST));
    const share = time / cue.length;
    set(ring, { "stroke-dasharray": ROUND, "stroke-dashoffset": ROUND * (1 - ringShare(share)) });
    set(disc, { r: discRadius(cue.kind, share) });
    write(seconds, COUNTED.has(cue.kind) ? String(Math.ceil(cue.length - time)) : "");
  };
  const turn = () => {
    if (signal.aborted) return;
    const cue = live.latest?.cue;
    if (cue && !element.hidden) draw(cue);
    requestAnimationFrame(turn);
  };
  /** @param {import("../live/live.js").PatientMessage} now */
  const show = ({ cue, state }) => {
    element.hidden = !cue || state === "fault";
    if (!cue) return;
    element.dataset.kind = cue.kind;
    write(words, cueWords(cue));
    const { kind, movement, next } = cue;
    const isMovement = movement && (kind === "ready" || next === "move");
    write(then, isMovement ? t("patient-cue-then-movement", { movement }) : next ? t(`patient-cue-then-${next}`) : "");
  };
  turn();
  return { element, show };
}
