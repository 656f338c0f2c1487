/**
 * Keeps a list of trials up to date: a trial begins, ends, counts or counts no more while somebody looks at it.
 * @import { ListedTrial } from "types/api"
 */

/**
 * Read the trials of a patient again after news of trials, and call `onChange` with a list that differs from the last.
 * @param {import("../../main.js").App} app @param {number} patient id @param {ListedTrial[]} trials as they were read
 * @param {(trials: ListedTrial[]) => void} onChange @param {AbortSignal} signal
 */
export function followTrials(app, patient, trials, onChange, signal) {
  let last = trials;
  /** @param {string} news the name of what changed on the server */
  const isAboutThem = (news) =>
    news === "everything" ||
    (news === "trial" && (app.session?.patient?.id === patient || last.some(({ status }) => status === "running")));
  /** @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (!isAboutThem(detail)) return;
    const now = await app.api.get(`/trials?patient=${patient}`).catch(() => last);
    if (signal.aborted || JSON.stringify(now) === JSON.stringify(last)) return;
    last = now;
    onChange(now);
  };
  app.live.addEventListener("changed", read, { signal });
}
