/** What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`. */
export { Fragment, h, render } from "../vendor/preact/preact.js";
export { signal } from "../vendor/@preact/signals/signals.js";
