/** Sends values that change faster than they should be sent: one at a time, at a limited rate, always the newest. */

/**
 * @template Value
 * @param {(value: Value) => Promise<unknown>} send handles its own failures @param {number} every ms from one call to the next
 * @returns {(value: Value) => void}
 */
export function newestWins(send, every) {
  /** @type {{value: Value} | null} */
  let waiting = null;
  let isBusy = false;
  return async (value) => {
    waiting = { value };
    if (isBusy) return;
    isBusy = true;
    while (waiting) {
      /** @type {{value: Value}} */
      const { value: now } = waiting;
      waiting = null;
      await Promise.all([send(now), new Promise((resolve) => setTimeout(resolve, every))]);
    }
    isBusy = false;
  };
}
