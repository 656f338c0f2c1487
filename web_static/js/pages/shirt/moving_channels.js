/** Which channels move: who moves one joint sees which lamps belong to it. */

const LOOK_BACK = 1; // s over which the span of a channel is taken
const LEAST = 0.8; // s of values before anything is said to move
const LOUDER = 4; // times the smallest span so far, which is that of a body at rest

/**
 * A function to be called with each message of a shirt that sends: it returns the indices of the channels that move, the
 * one that moves most first.
 * @returns {(t: number, values: (number | null)[], floors: number[]) => number[]} t: s; floors: spans of the noise
 */
export function movingChannels() {
  /** @type {{t: number, values: (number | null)[]}[]} */
  let recent = [];
  /** @type {number[]} the smallest span of each channel so far */
  let calm = [];
  return (t, values, floors) => {
    const before = recent.at(-1);
    if (before && (before.values.length !== values.length || t < before.t || t - before.t > LOOK_BACK)) {
      recent = [];
      calm = [];
    }
    recent.push({ t, values });
    recent = recent.filter((one) => one.t >= t - LOOK_BACK);
    if (t - recent[0].t < LEAST) return [];
    const shares = values.map((_, i) => {
      const span = spanOf(recent.map((one) => one.values[i]));
      if (span === null) return 0;
      calm[i] = Math.min(calm[i] ?? Infinity, span);
      const limit = Math.max(LOUDER * calm[i], floors[i] ?? 0);
      return span > limit ? span / (limit || span) : 0;
    });
    return [...shares.keys()].filter((i) => shares[i] > 0).sort((a, b) => shares[b] - shares[a]);
  };
}

/** How far values reach, null when one is missing. @param {(number | null)[]} values */
function spanOf(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null) return null;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return high - low;
}
