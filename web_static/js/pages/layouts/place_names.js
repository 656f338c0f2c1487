/**
 * What a place on the outline of the body is called: "Front: right elbow".
 * @import { Channel, Side } from "./layout_document.js"
 */
import { t } from "../../texts.js";

// In the shares of a layout (data/shirts/README.md): how far from the middle the trunk and the shoulders reach, and how
// far down each part does.
const TRUNK = 0.19;
const NECK = 0.13;
const HEAD_ENDS = 0.18;
const SHOULDER_ENDS = 0.33;
const CHEST_ENDS = 0.55;
/** @type {[number, string][]} */
const ARM = [
  [SHOULDER_ENDS, "shoulder"],
  [0.44, "upper-arm"],
  [0.54, "elbow"],
  [0.7, "forearm"],
  [0.78, "wrist"],
  [Infinity, "hand"],
];

/**
 * The part of the wearer's body at a place; `hand` is null in the middle.
 * @param {Side} side @param {[number, number]} position @returns {{part: string, hand: "left" | "right" | null}}
 */
export function partAt(side, [x, y]) {
  const outwards = Math.abs(x - 0.5);
  if (y < HEAD_ENDS && outwards < TRUNK) return { part: "head", hand: null };
  const isOnTrunk = outwards < (y < SHOULDER_ENDS ? NECK : TRUNK);
  if (isOnTrunk) return { part: TRUNK_PARTS[side][y < CHEST_ENDS ? 0 : 1], hand: null };
  const part = ARM.find(([end]) => y < end)?.[1] ?? "hand";
  // Seen from the front, the wearer's right is at the left of the picture.
  return { part, hand: x < 0.5 === (side === "front") ? "right" : "left" };
}

const TRUNK_PARTS = { front: ["chest", "belly"], back: ["upper-back", "lower-back"] };

/** Where a channel is, in words. @param {Channel} channel */
export function placeWords({ position, side }) {
  if (!position) return t("layouts-place-none");
  const { part, hand } = partAt(side ?? "front", position);
  const words = hand ? t(`layouts-part-${hand}-${part}`) : t(`layouts-part-${part}`);
  return t("layouts-place", { side: t(`shirt-${side ?? "front"}`), part: words });
}
