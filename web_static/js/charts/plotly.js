/** plotly, loaded from this machine and only when a chart is wanted; its colours follow the theme. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { palette } from "../shell/theme.js";

const SCRIPT = "/vendor/plotly.min.js";
const CONFIG = { displaylogo: false, displayModeBar: false, responsive: true, scrollZoom: false, doubleClick: false };

/** @type {Promise<any> | null} one script for as long as the page is open */
let loading = null;

/** @returns {Promise<any>} plotly itself */
function plotly() {
  loading ??= new Promise((resolve, reject) => {
    const script = h("script", { src: SCRIPT });
    script.onload = () => resolve(window["Plotly"]);
    script.onerror = () => {
      loading = null;
      script.remove();
      reject(new Error(t("review.chart.failed")));
    };
    document.head.append(script);
  });
  return loading;
}

/**
 * A chart that draws itself again when the theme changes.
 * @param {string} label @param {AbortSignal} signal
 * @param {(colours: Record<string, string>) => {traces: any[], layout: any}} make
 * @param {(point: any) => void} [onPoint] what a tap on a point does
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
  // Drawn once it stands in the page: only there it has a size.
  const stands = new ResizeObserver(() => {
    if (signal.aborted || !element.clientWidth) return;
    stands.disconnect();
    draw();
    document.addEventListener("themechange", draw);
    // Later, because plotly goes on with its own element after it has told of the tap.
    if (onPoint) element["on"]("plotly_click", ({ points }) => setTimeout(() => onPoint(points[0])));
  });
  stands.observe(element);
  signal.addEventListener("abort", () => {
    stands.disconnect();
    document.removeEventListener("themechange", draw);
    stop();
    Plotly.purge(element);
  });
  return element;
}

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
    hoverlabel: { bgcolor: colours.panel, bordercolor: colours.border, font: { color: colours.text } },
  };
}

function axis(colours) {
  return {
    gridcolor: colours.border,
    zerolinecolor: colours.border,
    linecolor: colours.border,
    fixedrange: true,
    automargin: true,
  };
}

/** A colour with less of it. @param {string} rgb as the browser gives it @param {number} share 0..1 */
export function faint(rgb, share) {
  const parts = rgb
    .match(/[\d.]+/g)
    ?.slice(0, 3)
    .map(Number) ?? [128, 128, 128];
  // color(srgb ...) counts from 0 to 1, rgb(...) to 255.
  const scale = rgb.startsWith("color(") ? 255 : 1;
  return `rgba(${parts.map((part) => Math.round(part * scale)).join(",")},${share})`;
}
