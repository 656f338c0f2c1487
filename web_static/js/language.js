/** The language of the pages: the folder of its texts, and how numbers and dates are written. */
export const LANGUAGE = "en";
