/** Which channels move now: people wiggle one, and see it light up. */

const WINDOW = 0.6; // s over which a movement is seen
const QUIET = 6; // times the noise: what noise alone spans in the window stays below
const LIT = 0.35; // share of the largest movement of a channel from which it is lit
const FORGET = 30; // s in which the largest movement fades to a third: a first jerk does not hide all that follows
const LEAST = 1e-9; // so that a constant signal never moves

export class ChannelMovement {
  /** @type {{t: number, values: (number | null)[]}[]} */
  #rows = [];
  /** @type {number[]} the largest span of each channel, in its units */
  #largest = [];

  /**
   * Add the newest frame.
   * @param {number} t s @param {(number | null)[]} values one per channel
   */
  push(t, values) {
    const last = this.#rows.at(-1);
    if (last && t === last.t) return;
    if (last && (t < last.t || values.length !== last.values.length)) {
      this.#rows = []; // another control process, or another shirt
      this.#largest = [];
    }
    const fade = last && t > last.t ? Math.exp((last.t - t) / FORGET) : 1;
    this.#rows.push({ t, values });
    while (t - this.#rows[0].t > WINDOW) this.#rows.shift();
    this.#largest = values.map((_, i) => Math.max(this.#span(i), (this.#largest[i] ?? 0) * fade));
  }

  /** The indices of the channels that move. @param {(number | null)[]} noise of each channel, in its units */
  moving(noise) {
    return this.#largest.flatMap((largest, i) => {
      const span = this.#span(i);
      return span > Math.max(LEAST, QUIET * (noise[i] ?? 0), LIT * largest) ? [i] : [];
    });
  }

  /** @param {number} index of the channel */
  #span(index) {
    const values = this.#rows.flatMap(({ values: row }) => row[index] ?? []);
    return values.length > 1 ? Math.max(...values) - Math.min(...values) : 0;
  }
}
