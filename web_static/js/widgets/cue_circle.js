/**
 * The large cue: a ring that fills with the time of the cue, and a disc that grows and shrinks with the movement.
 * @import { Cue } from "types/documents"
 */
import { t } from "../texts.js";
import { runNow } from "./cue_clock.js";
import { h, s, set, write } from "./dom.js";
import { number } from "./format.js";

const RADIUS = 118;
const ROUND = 2 * Math.PI * RADIUS;
const DISC_SMALL = 34; // radius at rest
const DISC_LARGE = 100; // radius at the end of the movement
const LONG_WORD = 8; // letters; longer ones are written smaller, to stay inside the ring
const CALM = matchMedia("(prefers-reduced-motion: reduce)");
const CALM_STEPS = 4; // of the ring, for people who prefer reduced motion
const COUNTED = new Set(["ready", "rest", "free"]); // whole seconds; the others are too short to be counted

/** What a cue asks for, in one word or two. @param {{kind: string, joint: string | null}} cue */
export function cueWords(cue) {
  return t(`cue-${cueName(cue)}`);
}

/** The end of the ids of its texts. @param {{kind: string, joint: string | null}} cue */
function cueName({ kind, joint }) {
  const part = kind === "move" && joint?.split("_").at(-1);
  return part && ["elbow", "wrist", "shoulder"].includes(part) ? `move-${part}` : kind;
}

/**
 * @param {import("../main.js").App} app @param {{cues: Cue[]}} step
 * @param {object} options
 * @param {boolean} options.isRunning @param {string} options.idleWords what stands below while nothing runs
 * @param {AbortSignal} options.signal @param {(cue: Cue) => void} options.onCue called with each new cue
 */
export function cueCircle(app, step, { isRunning, idleWords, signal, onCue }) {
  const disc = s("circle", { class: "disc", cx: 150, cy: 150, r: DISC_SMALL });
  const ring = s("circle", {
    class: "ring",
    cx: 150,
    cy: 150,
    r: RADIUS,
    "stroke-dasharray": ROUND,
    "stroke-dashoffset": ROUND,
    transform: "rotate(-90 150 150)",
  });
  const word = s("text", { class: "cue-word", x: 150, y: 158, "text-anchor": "middle" });
  const seconds = s("text", { class: "cue-seconds", x: 150, y: 192, "text-anchor": "middle" });
  const next = h("p", { class: "cue-next quiet" });
  const picture = s(
    "svg",
    { viewBox: "0 0 300 300", class: "cue-picture", "aria-hidden": "true" },
    s("circle", { class: "track", cx: 150, cy: 150, r: RADIUS }),
    disc,
    ring,
    word,
    seconds,
  );
  const element = h("div", { class: "cue" }, picture, next);
  let shown = -1;

  const idle = () => {
    set(ring, { "stroke-dashoffset": ROUND });
    set(disc, { r: DISC_SMALL });
    write(word, isRunning ? t("calibrate-wait") : "");
    write(seconds, "");
    write(next, idleWords);
    element.dataset.kind = "idle";
  };
  /** @param {{t: number, index: number}} now */
  const show = (now) => {
    const cue = step.cues[now.index];
    if (!cue) return idle();
    const share = (now.t - cue.start) / (cue.end - cue.start);
    set(ring, { "stroke-dashoffset": ROUND * (1 - ringShare(share)) });
    set(disc, { r: discRadius(cue.kind, share) });
    const left = cue.end - now.t;
    write(seconds, t("cue-seconds", { seconds: COUNTED.has(cue.kind) ? Math.ceil(left) : number(left, 1) }));
    if (now.index === shown) return;
    shown = now.index;
    element.dataset.kind = cue.kind;
    write(word, cueWords(cue));
    set(word, { "data-long": cueWords(cue).length > LONG_WORD || null });
    const after = step.cues[now.index + 1];
    write(next, t(`cue-next-${after ? cueName(after) : "end"}`));
    app.toasts.announce(cueWords(cue));
    onCue(cue);
  };
  const turn = () => {
    if (signal.aborted) return;
    const now = isRunning ? runNow(app.live, step.cues) : null;
    if (now) show(now);
    requestAnimationFrame(turn);
  };
  idle();
  turn();
  return element;
}

/** How much of the ring is filled: it grows smoothly, or in a few steps where reduced motion is preferred. @param {number} share of the cue's time, 0..1 */
export function ringShare(share) {
  return CALM.matches ? Math.floor(share * CALM_STEPS) / CALM_STEPS : share;
}

/**
 * The radius of the disc, which grows and shrinks smoothly to lead the movement, or at once in the middle of the cue
 * where reduced motion is preferred.
 * @param {string} kind of the cue @param {number} share of its time, 0..1
 */
export function discRadius(kind, share) {
  const ease = CALM.matches ? Number(share > 0.5) : 0.5 - 0.5 * Math.cos(Math.PI * Math.min(1, Math.max(0, share)));
  if (kind === "move") return DISC_SMALL + (DISC_LARGE - DISC_SMALL) * ease;
  if (kind === "return") return DISC_LARGE - (DISC_LARGE - DISC_SMALL) * ease;
  return DISC_SMALL;
}
