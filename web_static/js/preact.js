/** What draws the pages, and holds their state: Preact and its signals, of `web_static/vendor/`. */
export { Fragment, h, render } from "../vendor/preact/preact.js";
export { useEffect, useRef } from "../vendor/preact/hooks.js";
export { batch, computed, effect, signal, useComputed, useSignal } from "../vendor/@preact/signals/signals.js";
