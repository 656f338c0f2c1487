/**
 * Charts with axes. uPlot, loaded with the first chart, draws axes, lines and areas on a canvas. This module adds
 * marks, texts and a legend, and draws a chart anew when the theme changes.
 */
import { t } from "../texts.js";
import { h, put, write } from "../widgets/dom.js";
import { unrounded } from "../widgets/format.js";
import { palette } from "../shell/theme.js";
import { drawMark, legendItems } from "./symbols.js";
import { showTips } from "./tips.js";

const FONT = "13px system-ui, sans-serif";
const [LINE_ROOM, NUMBER_ROOM] = [20, 26]; // px of height, of an axis' name and of its numbers
const GAP = 6; // px between an axis and its numbers
const TOP = 10; // px above the frame, so that a number at its upper edge is whole
const RIGHT = 14; // px beside the frame, for the same
const BETWEEN = 4; // px between two texts of a row at least
/** Of an axis without values. @type {[number, number]} */
const NO_VALUES = [0, 1];
const WHOLE = { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500], space: 30 }; // steps, and px between two numbers at least

/**
 * @typedef {import("../../vendor/uplot/uPlot.js").default} Plot
 * @typedef {import("../../vendor/uplot/uPlot.js").default.Options} Options
 * @typedef {import("./symbols.js").Line} Line
 * @typedef {import("./symbols.js").Mark} Mark
 * @typedef {Record<"text" | "text-quiet" | "border" | "action" | "path-prescribed" | "path-driven", string>} Colours
 *
 * @typedef {{name: string, range?: [number, number], isWhole?: boolean}} Axis isWhole: numbers without decimals
 *
 * @typedef {object} Series points that a line joins, that enclose an area, or that are marked
 * @property {number[]} x @property {number[]} y
 * @property {string} [name] in the legend
 * @property {Line} [line] @property {string} [fill] colour of the area @property {Mark} [mark]
 * @property {number} [above] px over the frame at which the marks stand, whatever y is
 * @property {(i: number) => string} [words] what is said of a point under the pointer
 * @property {number[]} [ids] of the points, for a tap
 *
 * @typedef {object} TextRow texts in a row over the frame
 * @property {number} above px from the frame to the middle of the texts
 * @property {{x: number, text: string}[]} texts from left to right, over x or, when `isAfter`, to its right
 * @property {boolean} [isAfter] @property {string} [beside] what stands to the left of the frame, in the same row
 *
 * @typedef {object} Content
 * @property {Axis} x @property {Axis} y
 * @property {Series[]} series at least one
 * @property {number} [above] px over the frame, for what stands there
 * @property {[number, number][]} [bands] from where to where in x the background is darker
 * @property {TextRow[]} [rows]
 */

/**
 * @param {string} label @param {AbortSignal} signal @param {(colours: Colours) => Content} make
 * @param {(id: number) => void} [open] called with the id of a point after a tap on it
 */
export async function chart(label, signal, make, open) {
  const UPlot = await library();
  const axisName = h("figcaption", { class: "quiet small" });
  const legend = h("ul", { class: "chart-legend" });
  const place = h("div", { class: "plot", role: "img", "aria-label": label });
  const element = h("figure", { class: "chart" }, axisName, legend, place);
  if (signal.aborted) return element;
  const { colours, stop } = palette("text", "text-quiet", "border", "action", "path-prescribed", "path-driven");
  /** @type {Plot | null} as soon as the chart stands in the page: only then it has a size */
  let plot = null;
  let content = make(colours);
  const describe = () => {
    write(axisName, content.y.name);
    put(legend, legendItems(content.series));
  };
  const draw = () => {
    const { clientWidth: width, clientHeight: height } = place;
    if (!width) return;
    plot?.destroy();
    plot = new UPlot({ ...optionsOf(content, colours), width, height }, dataOf(content), place);
  };
  const resizing = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = place;
    if (!plot) draw();
    else if (width) plot.setSize({ width, height });
  });
  const redraw = () => {
    content = make(colours);
    describe();
    draw();
  };
  describe();
  resizing.observe(place);
  document.addEventListener("themechange", redraw, { signal });
  showTips(place, () => (plot ? pointsOf(plot, content) : []), signal, open);
  signal.addEventListener("abort", () => {
    resizing.disconnect();
    stop();
    plot?.destroy();
  });
  return element;
}

async function library() {
  try {
    return (await import("../../vendor/uplot/uPlot.js")).default;
  } catch {
    throw new Error(t("review-chart-failed"));
  }
}

/** In its mode 2 uPlot has x and y of each series; the first place is empty. @param {Content} content */
function dataOf({ series }) {
  const data = /** @type {unknown} */ ([null, ...series.map(({ x, y }) => [x, y])]);
  return /** @type {import("../../vendor/uplot/uPlot.js").default.AlignedData} */ (data);
}

/** @param {Content} content @param {Colours} colours @returns {Omit<Options, "width" | "height">} */
function optionsOf({ x, y, series, above = TOP, bands = [], rows = [] }, colours) {
  const axis = {
    stroke: colours["text-quiet"],
    font: FONT,
    labelFont: FONT,
    gap: GAP,
    grid: { stroke: colours.border, width: 1 },
    ticks: { show: false },
    /** @param {Plot} _ @param {number[]} splits */
    values: (_, splits) => splits.map((split) => unrounded(split)),
  };
  const beside = rows.flatMap((row) => row.beside ?? []);
  return {
    mode: 2,
    padding: [above, RIGHT, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: { x: { time: false, range: x.range ?? NO_VALUES }, y: { range: y.range ?? NO_VALUES } },
    axes: [
      { ...axis, label: x.name, labelSize: LINE_ROOM, size: NUMBER_ROOM, ...(x.isWhole && WHOLE) },
      // uPlot first asks for the width of an axis before it has its numbers.
      { ...axis, size: ({ ctx }, numbers) => 2 * GAP + widest(ctx, [...(numbers ?? []), ...beside]) },
    ],
    series: [
      {},
      ...series.map((one) => ({
        stroke: one.line?.colour,
        width: one.line?.width ?? 0,
        dash: one.line?.dash?.map((length) => length * devicePixelRatio),
        fill: one.fill,
        paths: (/** @type {Plot} */ plot) => outline(plot, one),
        points: { show: false },
      })),
    ],
    hooks: {
      drawClear: [(plot) => inFrame(plot, (pen) => drawBands(pen, plot, bands, above, faint(colours.text, 0.06)))],
      draw: [
        (plot) =>
          inFrame(plot, (pen) => {
            for (const one of series) drawMarks(pen, plot, one);
            pen.font = FONT;
            pen.fillStyle = colours["text-quiet"];
            for (const row of rows) drawRow(pen, plot, row);
          }),
      ],
    },
  };
}

/** The greatest width of some texts, px. @param {CanvasRenderingContext2D} pen @param {string[]} texts */
function widest(pen, texts) {
  pen.save();
  pen.font = FONT;
  const widths = texts.map((text) => pen.measureText(text).width);
  pen.restore();
  return Math.max(0, ...widths);
}

/** The line or the edge of an area. @param {Plot} plot @param {Series} series */
function outline(plot, { x, y }) {
  const path = new Path2D();
  x.forEach((value, i) => path.lineTo(plot.valToPos(value, "x", true), plot.valToPos(y[i], "y", true)));
  return { stroke: path, fill: path };
}

/**
 * Draw in pixels of the page from the upper left corner of the frame, as `valToPos` gives them.
 * @param {Plot} plot @param {(pen: CanvasRenderingContext2D) => void} paint
 */
function inFrame({ ctx: pen, bbox }, paint) {
  pen.save(); // uPlot expects that the context is as it has left it
  pen.setLineDash([]);
  pen.translate(bbox.left, bbox.top);
  pen.scale(devicePixelRatio, devicePixelRatio);
  paint(pen);
  pen.restore();
}

/**
 * @param {CanvasRenderingContext2D} pen @param {Plot} plot @param {[number, number][]} bands
 * @param {number} above px over the frame at which the bands begin @param {string} colour
 */
function drawBands(pen, plot, bands, above, colour) {
  pen.fillStyle = colour;
  for (const band of bands) {
    const [left, right] = band.map((x) => plot.valToPos(x, "x"));
    pen.fillRect(left, -above, right - left, above + plot.bbox.height / devicePixelRatio);
  }
}

/** @param {CanvasRenderingContext2D} pen @param {Plot} plot @param {Series} series */
function drawMarks(pen, plot, series) {
  if (series.mark) for (const { left, top } of placesOf(plot, series)) drawMark(pen, series.mark, left, top);
}

/** @param {CanvasRenderingContext2D} pen @param {Plot} plot @param {TextRow} row */
function drawRow(pen, plot, { above, texts, isAfter, beside }) {
  const most = plot.bbox.width / devicePixelRatio + RIGHT;
  const measured = texts.map(({ x, text }) => {
    const { width } = pen.measureText(text);
    const left = plot.valToPos(x, "x") + (isAfter ? GAP : -width / 2);
    return { text, width, left: Math.min(left, most - width) };
  });
  pen.textBaseline = "middle";
  pen.textAlign = "left";
  for (const { text, left } of withRoom(measured)) pen.fillText(text, left, -above);
  pen.textAlign = "right";
  if (beside) pen.fillText(beside, -GAP, -above);
}

/**
 * The texts of a row that stand on no other one: of two that are too close, the right one.
 * @template {{left: number, width: number}} Text in px
 * @param {Text[]} texts from left to right @returns {Text[]} from right to left
 */
export function withRoom(texts) {
  let end = Infinity;
  return texts.toReversed().filter(({ left, width }) => {
    if (left + width + BETWEEN > end) return false;
    end = left;
    return true;
  });
}

/**
 * Where the points of a series are, in px from the upper left corner of the frame.
 * @param {Plot} plot @param {Series} series
 */
function placesOf(plot, { x, y, above }) {
  return x.map((value, i) => ({
    left: plot.valToPos(value, "x"),
    top: above === undefined ? plot.valToPos(y[i], "y") : -above,
  }));
}

/**
 * The points that have words, in px of the window.
 * @param {Plot} plot @param {Content} content @returns {import("./tips.js").ChartPoint[]}
 */
function pointsOf(plot, { series }) {
  const frame = plot.over.getBoundingClientRect();
  return series.flatMap((one) => {
    const { words, ids } = one;
    if (!words) return [];
    return placesOf(plot, one).map(({ left, top }, i) => ({
      x: frame.left + left,
      y: frame.top + top,
      words: () => words(i),
      id: ids?.[i],
    }));
  });
}

/** A colour with an opacity. @param {string} rgb as the browser gives it @param {number} share 0..1 */
export function faint(rgb, share) {
  const parts = rgb
    .match(/[\d.]+/g)
    ?.slice(0, 3)
    .map(Number) ?? [128, 128, 128];
  // color(srgb ...) counts from 0 to 1, rgb(...) to 255.
  const scale = rgb.startsWith("color(") ? 255 : 1;
  return `rgba(${parts.map((part) => Math.round(part * scale)).join(",")},${share})`;
}
