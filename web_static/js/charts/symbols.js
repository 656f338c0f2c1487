/** The marks of points, on a canvas and in a legend: outlines around 0, 0 with a radius of about 1. */
import { h, s } from "../widgets/dom.js";

const RADIUS = 5; // px
const THICKNESS = 2; // px, of the lines of marks that are not filled
const CIRCLE = "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z";
const OUTLINES = /** @type {const} */ ({
  disc: CIRCLE,
  ring: CIRCLE,
  cross: "M-1 -1L1 1M-1 1L1 -1",
  diamond: "M0 -1.25L1.25 0L0 1.25L-1.25 0Z",
  square: "M-.9 -.9H.9V.9H-.9Z",
  "triangle-up": "M0 -1.2L1.1 .8H-1.1Z",
  "triangle-left": "M-1.2 0L.8 -1.1V1.1Z",
});
/** @type {Set<Mark["symbol"]>} */
const NOT_FILLED = new Set(["ring", "cross"]);

/**
 * @typedef {{symbol: keyof typeof OUTLINES, colour: string}} Mark of each point of a series
 * @typedef {{colour: string, width: number, dash?: number[]}} Line width and dashes in px
 */

/** @param {CanvasRenderingContext2D} pen @param {Mark} mark @param {number} x px @param {number} y px */
export function drawMark(pen, { symbol, colour }, x, y) {
  const outline = new Path2D(OUTLINES[symbol]);
  pen.save();
  pen.translate(x, y);
  pen.scale(RADIUS, RADIUS);
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = THICKNESS / RADIUS;
  if (NOT_FILLED.has(symbol)) pen.stroke(outline);
  else pen.fill(outline);
  pen.restore();
}

/**
 * The legend of a chart: the series that have a name, each behind its line, area or mark.
 * @param {{name?: string, line?: Line, fill?: string, mark?: Mark}[]} series
 */
export function legendItems(series) {
  return series.flatMap(({ name, line, fill, mark }) => {
    if (!name) return [];
    const sign = s(
      "svg",
      { viewBox: "-13 -7 26 14", "aria-hidden": "true" },
      fill && s("rect", { x: -12, y: -6, width: 24, height: 12, fill }),
      line &&
        s("path", {
          d: "M-12 0H12",
          stroke: line.colour,
          "stroke-width": line.width,
          "stroke-dasharray": line.dash?.join(" "),
        }),
      mark && markPath(mark),
    );
    return [h("li", {}, sign, name)];
  });
}

/** @param {Mark} mark */
function markPath({ symbol, colour }) {
  const isFilled = !NOT_FILLED.has(symbol);
  return s("path", {
    d: OUTLINES[symbol],
    transform: `scale(${RADIUS})`,
    fill: isFilled ? colour : "none",
    stroke: isFilled ? "none" : colour,
    "stroke-width": THICKNESS / RADIUS,
  });
}
