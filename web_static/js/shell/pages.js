/**
 * The pages that have an address of their own, `#/NAME`, each with what the frame has to know of it; the rail has its
 * steps in this order. What a person sees before the sign-in has no address, and no line here.
 * @import { IconName } from "../widgets/icons.js"
 */

/**
 * @typedef {object} PagePlace
 * @property {IconName} [icon] of its step in the rail; without an icon it has no step
 * @property {string} [below] the step that the rail marks while the page is shown
 * @property {boolean} [forReviewers] whether the rail shows its step to reviewers, who look and change nothing
 * @property {boolean} [ofSession] whether it shows, or changes, what belongs to the open session
 * @property {boolean} [withoutProgram] whether it works while the program does not answer
 */

/** @type {Record<string, PagePlace>} */
export const PAGES = {
  patients: { icon: "patients", forReviewers: true },
  shirt: { icon: "shirt", ofSession: true },
  calibrate: { icon: "calibrate", ofSession: true },
  controls: { icon: "controls", ofSession: true },
  drive: { icon: "drive", ofSession: true },
  review: { icon: "review", forReviewers: true },
  settings: { icon: "settings", forReviewers: true },
  layouts: { below: "shirt" },
  import_recording: { below: "shirt" },
  attention: { below: "review" },
  session: {},
  adapt: { ofSession: true },
  interface_test: { below: "drive", ofSession: true },
  plans: { below: "settings", withoutProgram: true }, // drawings are kept in this browser
  people: { below: "settings" },
  log: { below: "settings" },
  computer: { below: "settings" },
  backup: { below: "settings" },
};

/** What the frame has to know of a page; nothing where it has no address. @param {string} page @returns {PagePlace} */
export const placeOf = (page) => PAGES[page] ?? {};
