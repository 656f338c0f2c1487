/** Live traces on a canvas: some lines over the last seconds, newest at the right. */
import { h } from "../widgets/dom.js";
import { palette } from "../shell/theme.js";

const SECONDS = 10;
const MARGIN = 4; // px above and below
const SMALLEST_SPAN = 1e-6; // so that a flat line stays a flat line
const FADED = 0.55; // opacity when a chart has several lines

export class TraceCanvas {
  /** @type {number[]} */
  #times = [];
  /** @type {(number | null)[][]} */
  #rows = [];

  /**
   * @param {{label: string, height?: number, ownMiddle?: boolean, floor?: number}} options
   *   ownMiddle: each line about its own mean; floor: smallest span of the picture, in units of the signal
   */
  constructor({ label, height = 56, ownMiddle = true, floor = SMALLEST_SPAN }) {
    this.height = height;
    this.ownMiddle = ownMiddle;
    this.floor = floor;
    this.element = h("canvas", { class: "trace", role: "img", "aria-label": label, style: `height:${height}px` });
    this.palette = palette("action", "border");
  }

  /** @param {number} t seconds @param {(number | null)[]} values one per line */
  push(t, values) {
    const last = this.#times.at(-1);
    if (last !== undefined && t <= last) {
      if (t < last) this.clear(); // another control process counts its own time
      return;
    }
    this.#times.push(t);
    this.#rows.push(values);
    while (t - this.#times[0] > SECONDS) {
      this.#times.shift();
      this.#rows.shift();
    }
  }

  clear() {
    this.#times = [];
    this.#rows = [];
  }

  draw() {
    const canvas = this.element;
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth;
    if (!width) return;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(this.height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(this.height * ratio);
    }
    const pen = canvas.getContext("2d");
    if (!pen) return;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, this.height);
    pen.strokeStyle = this.palette.colours.border;
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(0, this.height / 2);
    pen.lineTo(width, this.height / 2);
    pen.stroke();
    if (this.#rows.length < 2) return;
    const lines = this.#rows[0].length;
    const middles = this.#middles(lines);
    const half = this.#halfSpan(lines, middles);
    const end = this.#times[this.#times.length - 1];
    pen.strokeStyle = this.palette.colours.action;
    pen.globalAlpha = lines > 1 ? FADED : 1;
    pen.lineWidth = lines > 1 ? 1.25 : 2;
    pen.lineJoin = "round";
    for (let line = 0; line < lines; line += 1) {
      pen.beginPath();
      let isDown = false;
      for (let i = 0; i < this.#rows.length; i += 1) {
        const value = this.#rows[i][line];
        if (value === null || value === undefined) {
          isDown = false;
          continue;
        }
        const x = width * (1 - (end - this.#times[i]) / SECONDS);
        const y = this.height / 2 - ((value - middles[line]) / half) * (this.height / 2 - MARGIN);
        if (isDown) pen.lineTo(x, y);
        else pen.moveTo(x, y);
        isDown = true;
      }
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  stop() {
    this.palette.stop();
  }

  /** The mean of each line. @param {number} lines their number */
  #middles(lines) {
    return Array.from({ length: lines }, (_, line) => {
      let low = Infinity;
      let high = -Infinity;
      for (const row of this.#rows) {
        const value = row[line];
        if (value === null || value === undefined) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
      }
      return this.ownMiddle && Number.isFinite(low) ? (low + high) / 2 : 0;
    });
  }

  /** Half of the span of the picture. @param {number} lines their number @param {number[]} middles */
  #halfSpan(lines, middles) {
    let half = this.floor / 2;
    for (const row of this.#rows) {
      for (let line = 0; line < lines; line += 1) {
        const value = row[line];
        if (value !== null && value !== undefined) half = Math.max(half, Math.abs(value - middles[line]));
      }
    }
    return half;
  }
}
