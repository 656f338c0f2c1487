/** The patient's view twice, each with the camera of one eye, laid out for a holder, a projector or coloured glasses. */
import { h, useLayoutEffect, useRef } from "../preact.js";
import { viewFrame } from "../view/view_frame.js";
import { aim, offset } from "./camera.js";
import { chosen } from "./settings.js";

/** @typedef {import("./camera.js").Side} Side */

/** @type {Side[]} */
const SIDES = ["left", "right"];
const AIM_EVERY = 100; // ms: a frame that was reloaded or resized has lost its camera's shift

// Colour matrices: the left eye sees the brightness of things through the red glass, the right eye green and blue. If the
// left eye saw only red, a red thing would shine for it and be black for the other eye.
const COLOURS = {
  left: "0.3 0.59 0.11 0 0  0 0 0 0 0  0 0 0 0 0  0 0 0 1 0",
  right: "0 0 0 0 0  0 1 0 0 0  0 0 1 0 0  0 0 0 1 0",
};

/**
 * @param {{round: number}} eyes round: with another one both views are loaded anew, because a frame that failed to load
 *   does not try again
 */
export function Eyes({ round }) {
  const { mode, split } = chosen.value;
  return h(
    "div",
    { class: split && mode !== "red-cyan" ? "eyes has-split" : "eyes", "data-mode": mode },
    h(ColourFilters, {}),
    SIDES.map((side) => h(Eye, { key: `${side} ${round}`, side })),
    h("div", { class: "split" }),
  );
}

/** @param {{side: Side}} eye */
function Eye({ side }) {
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  const choices = chosen.value;
  useLayoutEffect(() => {
    const gone = new AbortController();
    place.current?.append(viewFrame(gone.signal, "patient").element);
    const timer = setInterval(() => aimEye(side), AIM_EVERY);
    return () => {
      clearInterval(timer);
      gone.abort();
    };
  }, []);
  useLayoutEffect(() => aimEye(side), [choices]);
  const filter = choices.mode === "red-cyan" ? `url(#eye-${side})` : "";
  return h("div", { class: `eye ${side}`, style: { filter }, ref: place });
}

/** @param {Side} side */
function aimEye(side) {
  const choices = chosen.peek();
  aim(windowOf(side), offset(side, choices), Number(choices.convergence));
}

/** The age (s) of the older picture; Infinity while one is missing. */
export function pictureAge() {
  return Math.max(...SIDES.map((side) => windowOf(side)?.bodydriveView?.age() ?? Infinity));
}

/** The window of a view's frame; null while it shows an error page, which no page may read. @param {Side} side */
function windowOf(side) {
  try {
    /** @type {HTMLIFrameElement | null} */
    const frame = document.querySelector(`.eye.${side} iframe`);
    const view = frame?.contentWindow;
    return view?.document ? view : null;
  } catch {
    return null;
  }
}

function ColourFilters() {
  return h(
    "svg",
    { width: 0, height: 0, "aria-hidden": "true" },
    SIDES.map((side) =>
      h(
        "filter",
        { key: side, id: `eye-${side}`, "color-interpolation-filters": "sRGB", x: 0, y: 0, width: 1, height: 1 },
        h("feColorMatrix", { values: COLOURS[side] }),
      ),
    ),
  );
}
