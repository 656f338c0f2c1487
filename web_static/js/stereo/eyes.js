/** The patient's view twice, each with the camera of one eye, laid out for a holder, a projector or coloured glasses. */
import { h, put, s } from "../widgets/dom.js";
import { viewFrame } from "../view/view_frame.js";
import { aim, offset } from "./camera.js";

/** @type {import("./camera.js").Side[]} */
const SIDES = ["left", "right"];
const AIM_EVERY = 100; // ms: a frame that was reloaded or resized has lost its camera's shift

// Colour matrices: the left eye sees the brightness of things through the red glass, the right eye green and blue. If the
// left eye saw only red, a red thing would shine for it and be black for the other eye.
const COLOURS = {
  left: "0.3 0.59 0.11 0 0  0 0 0 0 0  0 0 0 0 0  0 0 0 1 0",
  right: "0 0 0 0 0  0 1 0 0 0  0 0 1 0 0  0 0 0 1 0",
};

export class Eyes {
  /** @param {import("./settings.js").Settings} settings @param {AbortSignal} signal */
  constructor(settings, signal) {
    this.settings = settings;
    this.places = SIDES.map((side) => h("div", { class: `eye ${side}` }));
    this.element = h("div", { class: "eyes" }, colourFilters(), this.places, h("div", { class: "split" }));
    this.frames = new AbortController();
    settings.addEventListener("change", () => this.#apply(), { signal });
    const timer = setInterval(() => this.#aim(), AIM_EVERY);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      this.frames.abort();
    });
    this.renew();
    this.#apply();
  }

  /** Load both views anew, because a frame that failed to load does not try again. */
  renew() {
    this.frames.abort();
    this.frames = new AbortController();
    for (const place of this.places) put(place, viewFrame(this.frames.signal, "patient").element);
  }

  /** The age (s) of the older picture. */
  age() {
    return Math.max(...this.places.map((place) => windowOf(place)?.bodydriveView?.age() ?? Infinity));
  }

  #apply() {
    const { mode, split } = this.settings.chosen;
    this.element.dataset.mode = mode;
    this.element.classList.toggle("has-split", split && mode !== "red-cyan");
    SIDES.forEach((side, i) => (this.places[i].style.filter = mode === "red-cyan" ? `url(#eye-${side})` : ""));
    this.#aim();
  }

  #aim() {
    const { chosen } = this.settings;
    SIDES.forEach((side, i) => aim(windowOf(this.places[i]), offset(side, chosen), Number(chosen.convergence)));
  }
}

/** The window of the view's frame; null while it shows an error page, which no page may read. @param {Element} place */
function windowOf(place) {
  try {
    const view = place.querySelector("iframe")?.contentWindow;
    return view?.document ? view : null;
  } catch {
    return null;
  }
}

function colourFilters() {
  return s(
    "svg",
    { width: 0, height: 0, "aria-hidden": "true" },
    SIDES.map((side) =>
      s(
        "filter",
        { id: `eye-${side}`, "color-interpolation-filters": "sRGB", x: 0, y: 0, width: 1, height: 1 },
        s("feColorMatrix", { values: COLOURS[side] }),
      ),
    ),
  );
}
