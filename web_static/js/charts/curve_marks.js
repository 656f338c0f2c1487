/** What stands along a learning curve: the sessions as light bands, and where the map became another version. */
import { t } from "../texts.js";

/**
 * @typedef {import("types/documents").LearningTrial} LearningTrial
 * @typedef {import("./plot.js").Series} Series
 * @typedef {import("./plot.js").TextRow} TextRow
 */

export const ABOVE = 52; // px over the frame; there are sessions, maps and below them their versions
const [SESSIONS, MAPS, VERSIONS] = [43, 26, 10]; // px from the frame to the middle of each
const WORD_ROOM = 1 / 3; // of the width: where the narrowest session has less, the word stands once, beside the numbers
/** The mark of a map by where it comes from. @type {Record<string, import("./symbols.js").Mark["symbol"]>} */
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

/** Every other session has a light band. @param {LearningTrial[]} rows @returns {[number, number][]} */
export function sessionBands(rows) {
  return sessions(rows)
    .filter((_, i) => i % 2 === 0)
    .map(({ first, last }) => [first - 0.5, last + 0.5]);
}

/** @param {LearningTrial[]} rows @returns {TextRow} */
export function sessionRow(rows) {
  const all = sessions(rows);
  const trials = all.length && rows[rows.length - 1].number - rows[0].number + 1;
  const hasRoom = all.every(({ first, last }) => last - first + 1 >= trials * WORD_ROOM);
  const texts = all.map(({ session, first, last }) => ({
    text: hasRoom ? t("review-session", { number: session }) : String(session),
    x: (first + last) / 2,
  }));
  return { above: SESSIONS, texts, beside: hasRoom ? undefined : t("review-sessions") };
}

/** The trials whose map is not that of the trial before. @param {LearningTrial[]} rows */
function changes(rows) {
  return rows.filter((row, i) => row.profile_version !== rows[i - 1]?.profile_version);
}

/** The versions of the maps, each where it begins. @param {LearningTrial[]} rows @returns {TextRow} */
export function versionRow(rows) {
  const texts = changes(rows)
    .filter(({ origin }) => origin in SYMBOLS)
    .map(({ number, profile_version }) => ({ x: number, text: String(profile_version) }));
  return { above: VERSIONS, texts };
}

/** A mark where each map begins. @param {LearningTrial[]} rows @param {string} colour @returns {Series[]} */
export function mapSeries(rows, colour) {
  const changed = changes(rows);
  return Object.entries(SYMBOLS)
    .map(([origin, symbol]) => ({ origin, symbol, some: changed.filter((row) => row.origin === origin) }))
    .filter(({ some }) => some.length)
    .map(({ origin, symbol, some }) => ({
      name: t(`review-map-${origin}`),
      x: some.map(({ number }) => number),
      y: some.map(() => 0),
      above: MAPS,
      mark: { symbol, colour },
      words: (i) => t(`review-map-from-${origin}`, { version: some[i].profile_version, number: some[i].number }),
    }));
}
