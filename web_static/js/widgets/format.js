/** Numbers, lists, times and dates as people read them in the language of the pages. */
import { LANGUAGE } from "../language.js";

const NONE = "–";
const MOST_DIGITS = 20; // after the point, of a number that is shown as it is
const LISTS = LANGUAGE === "en" ? "en-GB" : LANGUAGE; // "a, b and c"
const ALL = new Intl.ListFormat(LISTS, { type: "conjunction" });
const ANY = new Intl.ListFormat(LISTS, { type: "disjunction" });
/** What writes numbers, by its options; to make one takes longer than all that it writes. @type {Map<string, Intl.NumberFormat>} */
const WRITERS = new Map();
const CALENDAR_DAY = /^\d{4}-\d{2}-\d{2}$/;
const DAY = new Intl.DateTimeFormat(LANGUAGE, { day: "numeric", month: "short", year: "numeric" });
/** @type {Intl.DateTimeFormatOptions} */
const TO_THE_MINUTE = { day: "numeric", month: "short", hour: "2-digit", minute: "2-digit", hourCycle: "h23" };
/** @type {Intl.DateTimeFormatOptions} */
const WITH_YEAR = { ...TO_THE_MINUTE, year: "numeric" };
const MOMENT = new Intl.DateTimeFormat(LANGUAGE, TO_THE_MINUTE);
const MOMENT_OF_A_YEAR = new Intl.DateTimeFormat(LANGUAGE, WITH_YEAR);
const TO_THE_SECOND = new Intl.DateTimeFormat(LANGUAGE, { ...WITH_YEAR, second: "2-digit" });
const TIME = new Intl.DateTimeFormat(LANGUAGE, { timeStyle: "medium", hourCycle: "h23" });
const MINUTE = new Intl.DateTimeFormat(LANGUAGE, { hour: "2-digit", minute: "2-digit", hourCycle: "h23" });

/** @param {number | null | undefined} value @param {number} digits after the point */
export function number(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  return written(Number(value.toFixed(digits)), { minimumFractionDigits: digits, maximumFractionDigits: digits });
}

/** With as many digits as the value has. @param {number} value */
export function unrounded(value) {
  return written(value, { maximumFractionDigits: MOST_DIGITS });
}

/** At most so many significant digits. @param {number} value @param {number} digits */
export function significant(value, digits) {
  return written(Number(value.toPrecision(digits)), { maximumSignificantDigits: digits });
}

/** @param {number} value @param {Intl.NumberFormatOptions} options */
function written(value, options) {
  const key = JSON.stringify(options);
  const writer = WRITERS.get(key) ?? new Intl.NumberFormat(LANGUAGE, { useGrouping: false, ...options });
  WRITERS.set(key, writer);
  return writer.format(value + 0).replace("-", "−"); // -0 + 0 is 0
}

/** "a, b and c". @param {string[]} items */
export function allOf(items) {
  return ALL.format(items);
}

/** "a, b or c". @param {string[]} items */
export function anyOf(items) {
  return ANY.format(items);
}

/** With its sign, also when it is positive. @param {number | null | undefined} value @param {number} digits */
export function signed(value, digits) {
  const words = number(value, digits);
  return typeof value === "number" && Number.isFinite(value) && value > 0 && Number(value.toFixed(digits)) !== 0
    ? `+${words}`
    : words;
}

/** @param {number | null | undefined} share 0..1 */
export function percent(share) {
  return typeof share === "number" && Number.isFinite(share) ? `${number(Math.round(share * 100), 0)} %` : NONE;
}

/** With its sign, also when it is positive. @param {number | null | undefined} share -1..1 */
export function signedPercent(share) {
  return typeof share === "number" && Number.isFinite(share) ? `${signed(100 * share, 0)} %` : NONE;
}

/** Minutes and seconds. @param {number} seconds */
export function clock(seconds) {
  const whole = Math.max(0, Math.floor(seconds || 0));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** @param {string | null} iso a moment, or a day of the calendar, which is the same day everywhere */
export function day(iso) {
  return iso ? DAY.format(new Date(CALENDAR_DAY.test(iso) ? `${iso}T00:00` : iso)) : NONE;
}

/** With the year where it is not this one. @param {string | null} iso */
export function moment(iso) {
  if (!iso) return NONE;
  const date = new Date(iso);
  const isThisYear = date.getFullYear() === new Date().getFullYear();
  return (isThisYear ? MOMENT : MOMENT_OF_A_YEAR).format(date);
}

/** Always with the year, where the clock itself may be wrong. @param {string | number} at a moment, or ms of the wall clock */
export function dayAndTime(at) {
  return MOMENT_OF_A_YEAR.format(new Date(at));
}

/** Always with the year, to the second: of what is kept as evidence. @param {string} iso */
export function exactMoment(iso) {
  return TO_THE_SECOND.format(new Date(iso));
}

/** Hours, minutes and seconds of the day. @param {number} at ms of the wall clock */
export function timeOfDay(at) {
  return TIME.format(at);
}

/** Hours and minutes of the day. @param {string} iso */
export function minuteOfDay(iso) {
  return MINUTE.format(new Date(iso));
}

/** @param {number} bytes */
export function size(bytes) {
  if (bytes < 999_500) return `${number(Math.max(1, bytes / 1e3), 0)} kB`;
  return bytes < 999.95e6 ? `${number(bytes / 1e6, 1)} MB` : `${number(bytes / 1e9, 1)} GB`;
}

/** A share of the full movement, as people read it. @param {number | null | undefined} share 0..1 @param {string} unit "% / s" or "%" */
export function ofFull(share, unit) {
  return typeof share === "number" && Number.isFinite(share)
    ? `${number(100 * share, share !== 0 && Math.abs(share) < 0.1 ? 1 : 0)} ${unit}`
    : NONE;
}

/** Today, as an input of a date takes it. */
export function today() {
  const now = new Date();
  return new Date(now.getTime() - now.getTimezoneOffset() * 60_000).toISOString().slice(0, 10);
}
