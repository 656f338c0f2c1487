/**
 * The large cue: a ring that fills with the time of the cue, and a disc that grows and shrinks with the movement.
 * @import { Cue } from "types/documents"
 * @import { ReadonlySignal } from "../preact.js"
 * @import { RunMoment } from "./cue_clock.js"
 */
import { Fragment, h, useLayoutEffect } from "../preact.js";
import { t } from "../texts.js";
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
function cueWords(cue) {
  return t(`cue-${cueName(cue)}`);
}

/** The end of the ids of its texts. @param {{kind: string, joint: string | null}} cue */
function cueName({ kind, joint }) {
  const part = kind === "move" && joint?.split("_").at(-1);
  return part && ["elbow", "wrist", "shoulder"].includes(part) ? `move-${part}` : kind;
}

/**
 * @param {object} circle
 * @param {Cue[]} circle.cues of the step
 * @param {ReadonlySignal<RunMoment | null>} circle.moment of the run; null before it begins, and while nothing runs
 * @param {boolean} circle.isRunning @param {string} circle.idleWords what stands below while there is no cue
 * @param {(words: string) => void} circle.announce called with the words of each new cue
 */
export function CueCircle({ cues, moment, isRunning, idleWords, announce }) {
  const { t: time, index } = moment.value ?? { t: 0, index: -1 };
  /** @type {Cue | undefined} */
  const cue = cues[index];
  const word = cue ? cueWords(cue) : isRunning ? t("calibrate-wait") : "";
  useLayoutEffect(() => {
    if (cue) announce(word);
  }, [index]);
  const share = cue ? (time - cue.start) / (cue.end - cue.start) : 0;
  const left = cue ? cue.end - time : 0;
  return h(
    "div",
    { class: "cue", "data-kind": cue?.kind ?? "idle" },
    h(
      "svg",
      { viewBox: "0 0 300 300", class: "cue-picture", "aria-hidden": "true" },
      h(CueRing, { disc: cue ? discRadius(cue.kind, share) : DISC_SMALL, empty: ringEmpty(share) }),
      h(
        "text",
        {
          class: "cue-word",
          x: 150,
          y: 158,
          "text-anchor": "middle",
          "data-long": word.length > LONG_WORD ? "" : undefined,
        },
        word,
      ),
      h(
        "text",
        { class: "cue-seconds", x: 150, y: 192, "text-anchor": "middle" },
        cue && t("cue-seconds", { seconds: COUNTED.has(cue.kind) ? Math.ceil(left) : number(left, 1) }),
      ),
    ),
    h("p", { class: "cue-next quiet" }, cue ? nextWords(cues[index + 1]) : idleWords),
  );
}

/**
 * The ring, and the disc within it, in a picture of 300 x 300.
 * @param {{disc: number | ReadonlySignal<number>, empty: number | ReadonlySignal<number>}} ring the disc's radius, and
 *   how much of the ring's length is empty
 */
export function CueRing({ disc, empty }) {
  const middle = { cx: 150, cy: 150 };
  return h(
    Fragment,
    {},
    h("circle", { class: "track", ...middle, r: RADIUS }),
    h("circle", { class: "disc", ...middle, r: disc }),
    h("circle", {
      class: "ring",
      ...middle,
      r: RADIUS,
      "stroke-dasharray": ROUND,
      "stroke-dashoffset": empty,
      transform: "rotate(-90 150 150)",
    }),
  );
}

/** How much of the ring's length is empty. @param {number} share of the cue's time, 0..1 */
export const ringEmpty = (share) => ROUND * (1 - ringShare(share));

/** What comes after a cue. @param {Cue | undefined} cue the next one; undefined: the step ends */
function nextWords(cue) {
  return t(`cue-next-${cue ? cueName(cue) : "end"}`);
}

/**
 * How much of the ring is filled: it grows smoothly, or in a few steps where reduced motion is preferred.
 * @param {number} share of the cue's time, 0..1
 */
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
