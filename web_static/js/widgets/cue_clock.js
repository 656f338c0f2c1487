/**
 * The run's own time between two messages, so that the circle moves smoothly and yet says what is recorded.
 * @typedef {{t: number, index: number}} RunMoment s since the run began, and which of its cues that is
 */

const FURTHEST = 0.3; // s to go on without news; then the circle stands, because the run may stand too

/**
 * Where a run is now.
 * @param {import("../live/live.js").Live} live @param {{start: number, end: number}[]} cues
 * @returns {RunMoment | null} null outside a run
 */
export function runNow(live, cues) {
  const run = live.latest?.run;
  if (!run || run.t === null) return null;
  const t = run.t + Math.min(live.age, FURTHEST);
  const index = cues.findIndex(({ start, end }) => start <= t && t < end);
  return { t, index: index < 0 ? cues.length : index };
}
