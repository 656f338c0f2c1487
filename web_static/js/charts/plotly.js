/** plotly, loaded from the server when the first chart is drawn; its colours follow the theme. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { POINT } from "../widgets/format.js";
import { palette } from "../shell/theme.js";

const SCRIPT = new URL("../../vendor/plotly.js-basic-dist-min/plotly-basic.min.js", import.meta.url).href;
const CONFIG = { displaylogo: false, displayModeBar: false, responsive: true, scrollZoom: false, doubleClick: false };

/** @type {Promise<Plotly> | null} one script for as long as the page is open */
let loading = null;

/** Load plotly. @returns {Promise<Plotly>} */
function plotly() {
  loading ??= new Promise((resolve, reject) => {
    const script = h("script", { src: SCRIPT });
    script.onload = () => resolve(window.Plotly);
    script.onerror = () => {
      loading = null;
      script.remove();
      reject(new Error(t("review-chart-failed")));
    };
    document.head.append(script);
  });
  return loading;
}

/** @typedef {Record<"text" | "text-quiet" | "border" | "panel" | "action" | "path-prescribed" | "path-driven", string>} Colours */

/**
 * A chart that draws itself again when the theme changes.
 * @param {string} label @param {AbortSignal} signal
 * @param {(colours: Colours) => {traces: PlotlyTrace[], layout: PlotlyLayout}} make
 * @param {(point: PlotlyPoint) => void} [onPoint] called after a tap on a point
 */
export async function chart(label, signal, make, onPoint) {
  const { colours, stop } = palette(
    "text",
    "text-quiet",
    "border",
    "panel",
    "action",
    "path-prescribed",
    "path-driven",
  );
  const element = h("div", { class: "chart", role: "img", "aria-label": label });
  const Plotly = await plotly();
  const draw = () => {
    const { traces, layout } = make(colours);
    Plotly.react(
      element,
      traces,
      {
        ...frame(colours),
        ...layout,
        xaxis: { ...axis(colours), ...layout.xaxis },
        yaxis: { ...axis(colours), ...layout.yaxis },
      },
      CONFIG,
    );
  };
  // The chart is drawn when it stands in the page: only then it has a size.
  const placement = new ResizeObserver(() => {
    if (signal.aborted || !element.clientWidth) return;
    placement.disconnect();
    draw();
    document.addEventListener("themechange", draw);
    // The call is deferred, because plotly still uses its element after it has reported the tap.
    if (onPoint)
      /** @type {PlotlyElement} */ (/** @type {unknown} */ (element)).on("plotly_click", ({ points }) =>
        setTimeout(() => onPoint(points[0])),
      );
  });
  placement.observe(element);
  signal.addEventListener("abort", () => {
    placement.disconnect();
    document.removeEventListener("themechange", draw);
    stop();
    Plotly.purge(element);
  });
  return element;
}

/** @param {Colours} colours */
function frame(colours) {
  return {
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    dragmode: false,
    hovermode: "closest",
    autosize: true,
    font: { family: "system-ui, sans-serif", size: 13, color: colours["text-quiet"] },
    margin: { l: 56, r: 12, t: 8, b: 44 },
    legend: { orientation: "h", traceorder: "normal", x: 0, y: 1.02, yanchor: "bottom" },
    separators: POINT,
    hoverlabel: { bgcolor: colours.panel, bordercolor: colours.border, font: { color: colours.text } },
  };
}

/** @param {Colours} colours */
function axis(colours) {
  return {
    gridcolor: colours.border,
    zerolinecolor: colours.border,
    linecolor: colours.border,
    fixedrange: true,
    automargin: true,
    exponentformat: "none", // "0.0002", not "200µ"
  };
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
