/** The language of the pages, in which app/api/pages.py serves this module: how texts, numbers and dates are written. */
export const LANGUAGE = "en";
