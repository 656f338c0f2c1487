/** The one moment of a replay that all its pictures show, and how it goes on by itself. */
import { signal } from "../../preact.js";

export class PlayHead {
  isPlaying = signal(false);
  /** Times as fast as it was driven. */
  speed = signal(1);
  #t;
  #frame = 0;
  #last = 0;

  /** @param {number} start s @param {number} end s @param {AbortSignal} left of the page */
  constructor(start, end, left) {
    this.start = start;
    this.end = end;
    this.#t = signal(Math.max(start, Math.min(0, end)));
    left.addEventListener("abort", () => this.pause());
  }

  /** The moment in s; what Preact draws with it is drawn again at another moment. */
  get t() {
    return this.#t.value;
  }

  /** Show each moment from now on. @param {(t: number) => void} show @param {AbortSignal} until */
  follow(show, until) {
    until.addEventListener("abort", this.#t.subscribe(show));
  }

  /** Where a moment stands between start and end. @param {number} t s @returns {number} % */
  share(t) {
    return (100 * (Math.min(this.end, Math.max(this.start, t)) - this.start)) / (this.end - this.start || 1);
  }

  /** Go to a moment. @param {number} t s; one beyond the ends is the end */
  seek(t) {
    const within = Math.min(this.end, Math.max(this.start, t));
    if (Number.isFinite(within)) this.#t.value = within;
  }

  play() {
    if (this.isPlaying.value) return;
    if (this.t >= this.end) this.seek(this.start);
    this.isPlaying.value = true;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#go(now));
  }

  pause() {
    this.isPlaying.value = false;
    cancelAnimationFrame(this.#frame);
  }

  toggle() {
    if (this.isPlaying.value) this.pause();
    else this.play();
  }

  /** @param {number} now ms */
  #go(now) {
    this.seek(this.t + (this.speed.value * Math.max(0, now - this.#last)) / 1000);
    this.#last = now;
    if (this.t >= this.end) return this.pause();
    this.#frame = requestAnimationFrame((next) => this.#go(next));
  }
}

/** The last place in rising numbers that is not above a value; 0 before the first. @param {readonly (number | null)[]} values @param {number} value */
export function placeOf(values, value) {
  let [low, high] = [0, values.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (Number(values[middle]) <= value) low = middle;
    else high = middle - 1;
  }
  return low;
}
