/** What stands along a learning curve: the sessions as light bands, and where the map became another version. */
import { t } from "../texts.js";
import { faint } from "./plotly.js";

/**
 * @typedef {import("types/documents").LearningTrial} LearningTrial
 * @typedef {import("./plotly.js").Colours} Colours
 */

export const ABOVE = 0.82; // share of the chart's height that the curve has; sessions and maps stand above it
const MAPS = [0.84, 0.93]; // of the height
const SESSIONS = 0.94;
const WORD_ROOM = 1 / 3; // of the width: where the narrowest session has less, the word stands once, beside the numbers
const ROOM = 40; // numbers of maps that fit side by side over the whole width
/** The mark of a map by where it comes from. @type {Record<string, string>} */
const SYMBOLS = { calibration: "diamond", adaptation: "triangle-up", donning: "square", back: "triangle-left" };

/** The sessions: number, and from which to which trial. @param {LearningTrial[]} rows trials in order */
function sessions(rows) {
  /** @type {{session: number, first: number, last: number}[]} */
  const groups = [];
  for (const { session, number } of rows) {
    const newest = groups.at(-1);
    if (newest?.session === session) newest.last = number;
    else groups.push({ session, first: number, last: number });
  }
  return groups;
}

/**
 * Every other session has a light band.
 * @param {LearningTrial[]} rows @param {Pick<Colours, "text" | "path-prescribed">} colours
 */
export function sessionShapes(rows, colours) {
  return sessions(rows)
    .filter((_, i) => i % 2 === 0)
    .map(({ first, last }) => ({
      type: "rect",
      layer: "below",
      yref: "paper",
      x0: first - 0.5,
      x1: last + 0.5,
      y0: 0,
      y1: 1,
      line: { width: 0 },
      fillcolor: faint(colours.text, 0.06),
    }));
}

/** @param {LearningTrial[]} rows */
export function sessionWords(rows) {
  const all = sessions(rows);
  if (!all.length) return [];
  const trials = rows[rows.length - 1].number - rows[0].number + 1;
  const hasRoom = Math.min(...all.map(({ first, last }) => last - first + 1)) >= trials * WORD_ROOM;
  const place = { y: SESSIONS, yref: "paper", yanchor: "bottom", showarrow: false };
  const numbers = all.map(({ session, first, last }) => ({
    text: hasRoom ? t("review-session", { number: session }) : String(session),
    x: (first + last) / 2,
    ...place,
  }));
  return hasRoom
    ? numbers
    : [{ text: t("review-sessions"), x: 0, xref: "paper", xanchor: "right", xshift: -4, ...place }, ...numbers];
}

/** The row in which the maps stand. */
export function mapAxis() {
  return { domain: MAPS, range: [0, 1], visible: false, fixedrange: true };
}

/**
 * A mark with its version at each trial whose map is not that of the trial before.
 * @param {LearningTrial[]} rows @param {Pick<Colours, "text" | "path-prescribed">} colours
 */
export function mapTraces(rows, colours) {
  const changed = rows.filter((row, i) => row.profile_version !== rows[i - 1]?.profile_version);
  const apart = rows.length && (rows[rows.length - 1].number - rows[0].number + 1) / ROOM;
  /** @param {LearningTrial} row */
  const hasRoom = (row) => !(changed[changed.indexOf(row) + 1]?.number - row.number < apart);
  return Object.entries(SYMBOLS)
    .map(([origin, symbol]) => ({ origin, symbol, some: changed.filter((row) => row.origin === origin) }))
    .filter(({ some }) => some.length)
    .map(({ origin, symbol, some }) => ({
      mode: "markers+text",
      yaxis: "y2",
      x: some.map(({ number }) => number),
      y: some.map(() => 0.72),
      text: some.map((row) => (hasRoom(row) ? String(row.profile_version) : "")),
      textposition: "bottom center",
      marker: { symbol, size: 11, color: colours["path-prescribed"] },
      name: t(`review-map-${origin}`),
      hovertemplate: some.map(({ profile_version, number }) =>
        t(`review-map-from-${origin}`, { version: profile_version, number }).concat("<extra></extra>"),
      ),
    }));
}
