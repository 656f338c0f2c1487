/** The greatest age of a picture to drive by. */

const OLD = 1.0; // s: an older picture does not show the present
const OLD_WHEN_SLOW = 3.0; // s, while this page itself is late: then a picture in time may only be drawn late
const LATE = 450; // ms between two looks
const SLOW_FOR = 3000; // ms after a late look

export const LOOK_EVERY = 250; // ms

/**
 * Return a function that tells at each look whether the page was on time, and the greatest age of its picture (s).
 * @returns {() => {onTime: boolean, limit: number}} to be called every `LOOK_EVERY`
 */
export function ageLimit() {
  let lookedAt = performance.now();
  let lateAt = -Infinity;
  return () => {
    const now = performance.now();
    const onTime = now - lookedAt < LATE;
    if (!onTime) lateAt = now;
    lookedAt = now;
    return { onTime, limit: now - lateAt < SLOW_FOR ? OLD_WHEN_SLOW : OLD };
  };
}
