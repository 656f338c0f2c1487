/** Sends what changes faster than it should be sent: one at a time, never more often than asked, the newest always. */

/**
 * @template T
 * @param {(value: T) => Promise<any>} send its failures are its own @param {number} every ms between two
 * @returns {(value: T) => void}
 */
export function newestWins(send, every) {
  let waiting = null;
  let isBusy = false;
  return async (value) => {
    waiting = { value };
    if (isBusy) return;
    isBusy = true;
    while (waiting) {
      const { value: now } = waiting;
      waiting = null;
      await Promise.all([send(now), new Promise((resolve) => setTimeout(resolve, every))]);
    }
    isBusy = false;
  };
}
