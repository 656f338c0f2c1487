/** The few icons, drawn for this application on a grid of 24 by 24. */
import { h } from "../preact.js";
import { s } from "./dom.js";

const PATHS = {
  patients: ["M12 12a4 4 0 1 0 0-8 4 4 0 0 0 0 8Z", "M4.5 20.5c.6-4 3.6-6 7.5-6s6.9 2 7.5 6"],
  shirt: ["M8.5 3.5 3 6.5l2 5 2.5-1V20.5h9V10.5l2.5 1 2-5-5.5-3c-.7 1.6-2 2.4-3.5 2.4s-2.8-.8-3.5-2.4Z"],
  calibrate: [
    "M12 20.5a8.5 8.5 0 1 0 0-17 8.5 8.5 0 0 0 0 17Z",
    "M12 16a4 4 0 1 0 0-8 4 4 0 0 0 0 8Z",
    "M12 1.5v4M12 18.5v4M1.5 12h4M18.5 12h4",
  ],
  controls: ["M4 7h9M19 7h1M4 17h1M11 17h9", "M16 10a3 3 0 1 0 0-6 3 3 0 0 0 0 6ZM8 20a3 3 0 1 0 0-6 3 3 0 0 0 0 6Z"],
  drive: ["M10 6a2 2 0 1 0 0-4 2 2 0 0 0 0 4Z", "M10 8.5V14.5h5l3 5.5h2.5M10 11h4.5", "M7.5 12.2a5 5 0 1 0 6.8 6.3"],
  review: ["M4 4v16h16.5", "M7.5 8c2 6.5 5 8 12 8.5"],
  settings: [
    "M12 15.2a3.2 3.2 0 1 0 0-6.4 3.2 3.2 0 0 0 0 6.4Z",
    "M12 2.5v3M12 18.5v3M2.5 12h3M18.5 12h3M5.3 5.3l2.1 2.1M16.6 16.6l2.1 2.1M18.7 5.3l-2.1 2.1M7.4 16.6l-2.1 2.1",
    "M12 18.5a6.5 6.5 0 1 0 0-13 6.5 6.5 0 0 0 0 13Z",
  ],
  tick: ["m4 12.5 5.5 5.5L20 6.5"],
  cross: ["M6 6l12 12M18 6 6 18"],
  warning: ["M12 3.5 22 20.5H2Z", "M12 10v5M12 17.6v.4"],
  sun: [
    "M12 16.5a4.5 4.5 0 1 0 0-9 4.5 4.5 0 0 0 0 9Z",
    "M12 2v2.5M12 19.5V22M2 12h2.5M19.5 12H22M4.9 4.9l1.8 1.8M17.3 17.3l1.8 1.8M19.1 4.9l-1.8 1.8M6.7 17.3l-1.8 1.8",
  ],
  moon: ["M19.5 14.5A8 8 0 0 1 9.5 4.5a8 8 0 1 0 10 10Z"],
  contrast: ["M12 20.5a8.5 8.5 0 1 0 0-17 8.5 8.5 0 0 0 0 17Z", "M12 4v16M12 6.5h5.5M12 10h8M12 13.5h8M12 17h5.5"],
  leave: ["M14 4H5.5v16H14", "M10.5 12H21M17 8l4 4-4 4"],
  question: [
    "M12 20.5a8.5 8.5 0 1 0 0-17 8.5 8.5 0 0 0 0 17Z",
    "M9.5 9.5a2.5 2.5 0 1 1 3.8 2.1c-.9.5-1.3 1-1.3 2.1M12 16.8v.2",
  ],
  undo: ["M4 9.5h10.5a5.5 5.5 0 0 1 0 11H8", "M8 5 3.5 9.5 8 14"],
  redo: ["M20 9.5H9.5a5.5 5.5 0 0 0 0 11H16", "M16 5l4.5 4.5L16 14"],
  bin: ["M4.5 6.5h15M9.5 6.5V4h5v2.5M6.5 6.5l1 13.5h9l1-13.5M10.2 10v6.5M13.8 10v6.5"],
  plus: ["M12 5v14M5 12h14"],
  up: ["M12 20V5M6 11l6-6 6 6"],
  hide: ["M5 9l7 7 7-7"],
  play: ["M7 4.5v15l12-7.5Z"],
  pause: ["M8 5v14M16 5v14"],
};

/** @typedef {keyof typeof PATHS} IconName */

const LINES = {
  "aria-hidden": "true",
  fill: "none",
  stroke: "currentColor",
  "stroke-width": 1.8,
  "stroke-linecap": "round",
  "stroke-linejoin": "round",
};

/** @param {IconName} name @param {number} [size] in px */
export function icon(name, size = 24) {
  return s(
    "svg",
    { viewBox: "0 0 24 24", width: size, height: size, ...LINES },
    PATHS[name].map((d) => s("path", { d })),
  );
}

/** The same as a component. @param {{name: IconName, size?: number}} icon size: in px */
export function Icon({ name, size = 24 }) {
  return h(
    "svg",
    { viewBox: "0 0 24 24", width: size, height: size, .../** @type {object} */ (LINES) },
    PATHS[name].map((d) => h("path", { d, key: d })),
  );
}
