/**
 * The large cue of a calibration: the words, legible from 2 m, and a ring that fills with the time of the cue.
 * @import { PatientCue } from "types/api"
 * @import { Newest } from "./screen.js"
 * @import { PatientLive } from "./store.js"
 */
import { h, useComputed, useLayoutEffect, useSignal } from "../preact.js";
import { CueRing, discRadius, ringEmpty } from "../widgets/cue_circle.js";
import { t } from "../texts.js";

const FURTHEST = 0.3; // s for which the ring goes on without a message; then it stops, because the run may have stopped too
const COUNTED = new Set(["ready", "rest", "free"]); // whole seconds; the others are too short to be counted

/** @param {Newest & {live: PatientLive}} layer */
export function CueLayer({ live, now }) {
  const cue = useComputed(() => (now.value?.state === "fault" ? null : now.value?.cue));
  const words = useComputed(() => cue.value && cueWords(cue.value));
  const then = useComputed(() => cue.value && thenWords(cue.value));
  const kind = useComputed(() => cue.value?.kind).value;
  return h(
    "div",
    { class: "cue-layer", hidden: !kind, "data-kind": kind },
    h(Ring, { live, isShown: Boolean(kind) }),
    h("p", { class: "cue-words", role: "status" }, words),
    h("p", { class: "cue-then" }, then),
  );
}

/** The words of a cue. @param {PatientCue} cue */
function cueWords({ kind, movement }) {
  return kind === "move" && movement ? movement : t(`patient-cue-${kind}`);
}

/** What comes after a cue. @param {PatientCue} cue */
function thenWords({ kind, movement, next }) {
  if (movement && (kind === "ready" || next === "move")) return t("patient-cue-then-movement", { movement });
  return next ? t(`patient-cue-then-${next}`) : "";
}

/**
 * The ring, and the disc that leads the movement: they move with each frame of the browser.
 * @param {{live: PatientLive, isShown: boolean}} ring
 */
function Ring({ live, isShown }) {
  const time = useSignal({ kind: "rest", length: 1, t: 0 }); // of the cue, s
  const share = useComputed(() => time.value.t / time.value.length);
  const disc = useComputed(() => discRadius(time.value.kind, share.value));
  const empty = useComputed(() => ringEmpty(share.value));
  const seconds = useComputed(() => {
    const { kind, length, t: past } = time.value;
    return COUNTED.has(kind) ? String(Math.ceil(length - past)) : "";
  });
  useLayoutEffect(() => {
    if (!isShown) return;
    let frame = 0;
    const turn = () => {
      const cue = live.latest?.cue;
      if (cue) time.value = { ...cue, t: Math.min(cue.length, cue.t + Math.min(live.age, FURTHEST)) };
      frame = requestAnimationFrame(turn);
    };
    turn();
    return () => cancelAnimationFrame(frame);
  }, [isShown]);
  return h(
    "svg",
    { viewBox: "0 0 300 300", "aria-hidden": "true" },
    h(CueRing, { disc, empty }),
    h("text", { class: "seconds", x: 150, y: 172, "text-anchor": "middle" }, seconds),
  );
}
