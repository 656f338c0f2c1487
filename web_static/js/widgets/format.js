/** Numbers, times and dates as people read them. */
import { LANGUAGE } from "../language.js";

const NONE = "–";
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
  const rounded = Number(value.toFixed(digits));
  return (Object.is(rounded, -0) ? 0 : rounded).toFixed(digits).replace("-", "−");
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
  return typeof share === "number" && Number.isFinite(share) ? `${Math.round(share * 100)} %` : NONE;
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
  if (bytes < 999_500) return `${Math.max(1, Math.round(bytes / 1e3))} kB`;
  return bytes < 999.95e6 ? `${(bytes / 1e6).toFixed(1)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
}

/** A share of the full movement, as people read it. @param {number | null | undefined} share 0..1 @param {string} unit "% / s" or "%" */
export function ofFull(share, unit) {
  return typeof share === "number" && Number.isFinite(share)
    ? `${number(100 * share, share !== 0 && Math.abs(share) < 0.1 ? 1 : 0)} ${unit}`
    : NONE;
}
