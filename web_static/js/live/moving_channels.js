/** Which channels of the shirt move: who moves one joint, or one sensor, sees which they are. */
import { signal } from "../preact.js";

const LOOK_BACK = 1; // s over which the span of a channel is taken
const LEAST_TIME = 0.8; // s of values before a channel is said to move
const QUIET = 8; // times the noise: what noise alone spans stays below
const LOUDER = 4; // times the smallest span so far, which is that of a body at rest
const LIT = 0.35; // share of the largest span of the channel: less is what moves along with another one
const FORGET = 30; // s in which the largest span fades to a third: a first jerk does not hide all that follows
const CONSTANT = 1e-9; // so that a constant signal never moves

/** @typedef {{t: number, values: (number | null)[]}} Row what a message says of the channels; t: s */

/**
 * Signals of the channels that move now, by their indices, and of the one that moves most, -1 for none.
 * @param {import("./live.js").Live} live @param {AbortSignal} left of the page
 */
export function movingNow(live, left) {
  const moving = signal(/** @type {number[]} */ ([]));
  const most = signal(-1);
  const find = movingChannels();
  live.addEventListener(
    "tick",
    ({ detail: { t, values, shirt } }) => {
      const found = shirt.alive && values && t !== null ? find(t, values, live.noise) : [];
      const indices = [...found].sort((a, b) => a - b);
      if (indices.join() !== moving.peek().join()) moving.value = indices;
      most.value = found[0] ?? -1;
    },
    { signal: left },
  );
  return { moving, most };
}

/**
 * A function to be called with each message of a shirt that sends: it returns the indices of the channels that move, the
 * one that moves most first. Nothing is seen to move before it has rested once.
 * @returns {(t: number, values: (number | null)[], noise: (number | null)[]) => number[]} t: s; noise: in units of a channel
 */
export function movingChannels() {
  /** @type {Row[]} */
  let recent = [];
  /** @type {number[]} the smallest span of each channel so far */
  let calm = [];
  /** @type {number[]} the largest, which fades */
  let largest = [];
  return (t, values, noise) => {
    const before = recent.at(-1);
    if (before && (before.values.length !== values.length || t < before.t || t - before.t > LOOK_BACK)) {
      [recent, calm, largest] = [[], [], []]; // another shirt or control process, or a pause
    }
    const fade = Math.exp(((recent.at(-1)?.t ?? t) - t) / FORGET);
    recent.push({ t, values });
    recent = recent.filter((row) => row.t >= t - LOOK_BACK);
    const shares = values.map((_, i) => {
      const span = spanOf(recent, i);
      if (span === null) return 0;
      calm[i] = Math.min(calm[i] ?? Infinity, span);
      largest[i] = Math.max(span, (largest[i] ?? 0) * fade);
      const rest = Math.max(CONSTANT, QUIET * (noise[i] ?? 0), LOUDER * calm[i]);
      return span > Math.max(rest, LIT * largest[i]) ? span / rest : 0;
    });
    return [...shares.keys()].filter((i) => shares[i] > 0).sort((a, b) => shares[b] - shares[a]);
  };
}

/** How far the values of a channel reach; null when they cover too short a time. @param {Row[]} rows @param {number} index */
function spanOf(rows, index) {
  let [low, high, first, last] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const { t, values } of rows) {
    const value = values[index];
    if (value === null) continue;
    [low, high] = [Math.min(low, value), Math.max(high, value)];
    [first, last] = [Math.min(first, t), t];
  }
  return last - first < LEAST_TIME ? null : high - low;
}
