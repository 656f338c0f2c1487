/** What stands along a learning curve: the sessions as light bands, and where the map became another version. */
import { t } from "../texts.js";
import { faint } from "./plotly.js";

export const ABOVE = 0.82; // share of the chart's height that the curve has; sessions and maps stand above it
const MAPS = [0.84, 0.93]; // of the height
const SESSIONS = 0.94;
const MANY = 6; // sessions: from then on the word stands only at the first
const ROOM = 40; // numbers of maps side by side over the whole width; closer ones would stand on one another
const SYMBOLS = { calibration: "diamond", adaptation: "triangle-up", back: "triangle-left" };

/** The sessions: number, and from which to which trial. @param {any[]} rows trials in order */
function sessions(rows) {
  const found = [];
  for (const { session, number } of rows) {
    if (found.at(-1)?.session === session) found.at(-1).last = number;
    else found.push({ session, first: number, last: number });
  }
  return found;
}

/** Every other session has a light band. @param {any[]} rows @param {Record<string, string>} colours */
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

/** @param {any[]} rows */
export function sessionWords(rows) {
  const all = sessions(rows);
  return all.map(({ session, first, last }, i) => ({
    text: all.length > MANY && i > 0 ? String(session) : t("review.session", { number: session }),
    x: (first + last) / 2,
    y: SESSIONS,
    yref: "paper",
    yanchor: "bottom",
    showarrow: false,
  }));
}

/** The row in which the maps stand. */
export function mapAxis() {
  return { domain: MAPS, range: [0, 1], visible: false, fixedrange: true };
}

/** A mark with its version where the map is another one than in the trial before. @param {any[]} rows @param {Record<string, string>} colours */
export function mapTraces(rows, colours) {
  const changed = rows.filter((row, i) => row.profile_version !== rows[i - 1]?.profile_version);
  const apart = rows.length && (rows.at(-1).number - rows[0].number + 1) / ROOM;
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
      name: t(`review.map.${origin}`),
      hovertemplate: some.map(({ profile_version, number }) =>
        t(`review.map.from.${origin}`, { version: profile_version, number }).concat("<extra></extra>"),
      ),
    }));
}
