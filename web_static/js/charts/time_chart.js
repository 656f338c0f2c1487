/** Lines over the time of a replay, on a canvas that is drawn once; only the cursor and the numbers change. */
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { h, write } from "../widgets/dom.js";
import { number } from "../widgets/format.js";
import { placeOf } from "../pages/review/play_head.js";

const LEFT = 46; // px for the numbers at the side
const RIGHT = 10;
const EDGE = 8; // px above and below
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3]];
const THICKNESS = 1.75; // px of a line

/**
 * @template {string} Colour
 * @typedef {{name: string, values: (number | null)[], colour: Colour}} Line colour: a name of the palette
 */

/**
 * @template {string} Colour
 * @typedef {object} ChartContent
 * @property {string} title
 * @property {string} unit
 * @property {(number | null)[]} times s
 * @property {number[]} state of the chair at each time (app.faults.State)
 * @property {Line<Colour>[]} lines
 * @property {number} [digits]
 * @property {[number, number]} [range] at least this is shown
 * @property {number} [height] px
 */

/**
 * @template {string} Colour
 * @param {ChartContent<Colour>} content
 * @param {import("../pages/review/play_head.js").PlayHead} head
 * @param {Record<Colour | "border" | "text-quiet", string>} colours that follow the theme
 */
export function timeChart({ title, unit, times, state, lines, digits = 2, range, height = 96 }, head, colours) {
  const canvas = h("canvas", { role: "img", "aria-label": t("replay-chart", { title }) });
  const cursor = h("i", { class: "cursor" });
  const values = lines.map(() => h("span", { class: "number" }));
  const legend = lines.map((line, i) =>
    h("span", { class: "legend" }, swatch(line.colour, i), line.name, " ", values[i]),
  );
  const box = h("div", { class: "chart-box", style: `height:${height}px` }, canvas, cursor);
  const element = h(
    "figure",
    { class: "time-chart" },
    h(
      "figcaption",
      {},
      h("b", {}, title),
      unit && h("span", { class: "quiet" }, ` ${unit}`),
      h("span", { class: "legends" }, legend),
    ),
    box,
  );
  const { low, high } = spanOf(lines, range);
  let width = 0;
  /** @param {number | null} now s @returns {number} px */
  const xAt = (now) =>
    LEFT + ((Number(now) - head.start) / (head.end - head.start || 1)) * Math.max(1, width - LEFT - RIGHT);
  /** @param {number} value @returns {number} px */
  const yAt = (value) => EDGE + ((high - value) / (high - low)) * (height - 2 * EDGE);

  const draw = () => {
    width = box.clientWidth;
    if (!width) return;
    const ratio = window.devicePixelRatio || 1;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const pen = canvas.getContext("2d");
    if (!pen) return;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    shadeUnarmed(pen);
    drawAxis(pen);
    lines.forEach((line, i) => drawLine(pen, line, i));
    show();
  };

  /** @param {CanvasRenderingContext2D} pen */
  const shadeUnarmed = (pen) => {
    pen.fillStyle = colours.border;
    pen.globalAlpha = 0.45;
    for (let i = 0; i < times.length;) {
      let last = i;
      while (
        last + 1 < times.length &&
        (state[last + 1] === REFERENCE.numbers.armed) === (state[i] === REFERENCE.numbers.armed)
      )
        last += 1;
      const [from, to] = [xAt(times[i]), xAt(times[Math.min(last + 1, times.length - 1)])];
      if (state[i] !== REFERENCE.numbers.armed) pen.fillRect(from, 0, to - from, height);
      i = last + 1;
    }
    pen.globalAlpha = 1;
  };

  /** @param {CanvasRenderingContext2D} pen */
  const drawAxis = (pen) => {
    pen.font = "12px system-ui, sans-serif";
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    pen.lineWidth = 1;
    const marked = low < 0 && high > 0 ? [low, 0, high] : [low, high];
    for (const value of marked) {
      const y = Math.round(yAt(value)) + 0.5;
      pen.strokeStyle = colours.border;
      pen.beginPath();
      pen.moveTo(LEFT, y);
      pen.lineTo(width - RIGHT, y);
      pen.stroke();
      pen.fillStyle = colours["text-quiet"];
      const isClose = value === 0 && marked.some((other) => other !== 0 && Math.abs(yAt(other) - y) < 14);
      if (!isClose) pen.fillText(number(value, digits), LEFT - 6, y);
    }
  };

  /** @param {CanvasRenderingContext2D} pen @param {Line<Colour>} line @param {number} i */
  const drawLine = (pen, line, i) => {
    pen.strokeStyle = colours[line.colour];
    pen.lineWidth = THICKNESS;
    pen.lineJoin = "round";
    pen.setLineDash(DASHES[Math.floor(i / 6) + (lines.length > 1 ? i % DASHES.length : 0)] ?? []);
    pen.beginPath();
    let isDown = false;
    for (let k = 0; k < times.length; k += 1) {
      const value = line.values[k];
      if (value === null) {
        isDown = false;
        continue;
      }
      if (isDown) pen.lineTo(xAt(times[k]), yAt(value));
      else pen.moveTo(xAt(times[k]), yAt(value));
      isDown = true;
    }
    pen.stroke();
    pen.setLineDash([]);
  };

  const show = () => {
    cursor.style.transform = `translateX(${xAt(head.t)}px)`;
    const now = placeOf(times, head.t);
    lines.forEach((line, i) => write(values[i], number(line.values[now], digits)));
  };

  /** @param {PointerEvent} event */
  const seek = (event) => {
    const inner = event.clientX - box.getBoundingClientRect().left - LEFT;
    head.pause();
    head.seek(head.start + (inner / Math.max(1, width - LEFT - RIGHT)) * (head.end - head.start));
  };
  box.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    box.setPointerCapture(event.pointerId);
    seek(event);
  });
  box.addEventListener("pointermove", (event) => box.hasPointerCapture(event.pointerId) && seek(event));
  return { element, draw, show };
}

/** @param {string} colour @param {number} i */
function swatch(colour, i) {
  return h("i", {
    class: "swatch",
    style: `border-top: 3px ${i % DASHES.length ? "dashed" : "solid"} var(--${colour})`,
  });
}

/**
 * The least and the greatest value, with some room when all are equal.
 * @param {{values: (number | null)[]}[]} lines @param {[number, number]} [range] at least this
 */
function spanOf(lines, range = [Infinity, -Infinity]) {
  let [low, high] = range;
  for (const { values } of lines)
    for (const value of values) if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (!Number.isFinite(low)) [low, high] = [0, 1];
  if (high - low < 1e-6) [low, high] = [low - 0.5, high + 0.5];
  return { low, high };
}
