/** The patient's view twice, each with the camera of one eye, laid out for a holder, a projector or coloured glasses. */
import { h, put, s } from "../widgets/dom.js";
import { viewFrame } from "../view/view_frame.js";
import { aim, aside } from "./camera.js";

/** @type {("left" | "right")[]} */
const SIDES = ["left", "right"];
const AIM_EVERY = 100; // ms: a frame that was loaded again, or changed its shape, has forgotten

// The left eye sees how bright things are, through the red glass; the right one sees green and blue. With red alone,
// a red thing would shine for one eye and be black for the other.
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
    this.shown = new AbortController();
    settings.addEventListener("change", () => this.#apply(), { signal });
    const timer = setInterval(() => this.#aim(), AIM_EVERY);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      this.shown.abort();
    });
    this.renew();
    this.#apply();
  }

  /** Load both views anew: one that failed to load stays as it is. */
  renew() {
    this.shown.abort();
    this.shown = new AbortController();
    for (const place of this.places) put(place, viewFrame(this.shown.signal, "patient").element);
  }

  /** How old the older picture is, s. */
  age() {
    return Math.max(...this.places.map((place) => windowOf(place)?.bodydriveView?.age() ?? Infinity));
  }

  #apply() {
    const { mode, split } = this.settings.chosen;
    this.element.dataset.mode = mode;
    this.element.classList.toggle("has-split", split && mode !== "red-cyan");
    SIDES.forEach((side, i) => (this.places[i].style.filter = mode === "red-cyan" ? `url(#seen-${side})` : ""));
    this.#aim();
  }

  #aim() {
    const { chosen } = this.settings;
    SIDES.forEach((side, i) => aim(windowOf(this.places[i]), aside(side, chosen), Number(chosen.convergence)));
  }
}

/** The window of the view's frame; null while it shows an error page, which belongs to nobody. */
function windowOf(place) {
  try {
    const view = place.querySelector("iframe").contentWindow;
    return view.document && view;
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
        { id: `seen-${side}`, "color-interpolation-filters": "sRGB", x: 0, y: 0, width: 1, height: 1 },
        s("feColorMatrix", { values: COLOURS[side] }),
      ),
    ),
  );
}
