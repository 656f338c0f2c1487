/** The part of plotly that web_static/js/charts uses; its package ships no types. */

/** A line or a group of points: plotly knows some hundred fields. */
type PlotlyTrace = Record<string, unknown>;

type PlotlyLayout = Record<string, unknown> & { xaxis?: Record<string, unknown>; yaxis?: Record<string, unknown> };

/** A point that was tapped, with what its trace gave as `customdata`. */
interface PlotlyPoint {
  customdata?: unknown;
}

interface Plotly {
  react(element: HTMLElement, traces: PlotlyTrace[], layout: PlotlyLayout, config: Record<string, unknown>): unknown;
  purge(element: HTMLElement): void;
}

/** An element after plotly has drawn on it. */
interface PlotlyElement extends HTMLElement {
  on(event: "plotly_click", listener: (event: { points: PlotlyPoint[] }) => void): void;
}

interface Window {
  Plotly: Plotly;
}
