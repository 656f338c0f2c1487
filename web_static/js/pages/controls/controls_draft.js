/**
 * The controls as they are being edited: changes show at once, are sent when the hand rests, and go back when refused.
 * @import { Binding, ControlSettings, ControlsView, Gesture, Speeds } from "types/api"
 */
import { failureWords } from "../../api.js";
import { TypedEvents } from "../../live/typed_events.js";
import { gestureFor, newGestureName } from "../../widgets/gestures.js";

const REST = 400; // ms without another change, then it is sent
const LEAST_GAP = 0.02; // FS/s or FS

/**
 * `shape`: the page is to be drawn again; `handles`: the detail is the gesture whose handles moved; `refused`: the
 * detail is the server's sentence; `obstacle`: another reason than before, or none any more, why they cannot drive.
 * @typedef {{shape: Event, handles: CustomEvent<Gesture>, saving: Event, saved: Event, refused: CustomEvent<string>, obstacle: Event}} DraftEvents
 * @typedef {Binding["control"]} Control
 * @typedef {"cutoff" | "cruise_time" | "turn_cruise_time"} ValueName of a setting that is one number
 */

/** @extends {TypedEvents<DraftEvents>} */
export class ControlsDraft extends TypedEvents {
  #timer = 0;
  #sending = Promise.resolve();

  /** @param {import("../../api.js").Api} api @param {ControlsView} view what GET /controls answered */
  constructor(api, view) {
    super();
    this.api = api;
    this.view = view;
    this.settings = settingsOf(view);
  }

  get profile() {
    return this.view.parameters.profile;
  }

  get limits() {
    return this.view.limits;
  }

  /** @param {Control} control @returns {Binding} */
  binding(control) {
    return this.settings.bindings.find((binding) => binding.control === control) ?? { control, gestures: [], gain: 1 };
  }

  /** @param {string} name */
  gesture(name) {
    return this.settings.gestures.find((gesture) => gesture.name === name);
  }

  /** @param {string} name @param {number} from @param {number} full */
  setHandles(name, from, full) {
    const gesture = this.gesture(name);
    if (!gesture) return;
    gesture.dead_zone = Number(from.toFixed(4));
    gesture.full = Number(Math.max(full, from + LEAST_GAP).toFixed(4));
    this.dispatchEvent(new CustomEvent("handles", { detail: gesture }));
    this.#changed();
  }

  /** @param {string} name @param {Gesture["feature"]} feature */
  setFeature(name, feature) {
    const gesture = this.gesture(name);
    if (!gesture) return;
    gesture.feature = feature;
    this.#changed(true);
  }

  /** @param {Control} control @param {number} gain */
  setGain(control, gain) {
    this.#ownBinding(control).gain = gain;
    this.#changed();
  }

  /** @param {ValueName} name @param {number} value */
  setValue(name, value) {
    this.settings[name] = value;
    this.#changed();
  }

  /** @param {"mode_u1" | "mode_u2"} name @param {ControlSettings["mode_u1"]} mode */
  setMode(name, mode) {
    this.settings[name] = mode;
    this.#changed(true);
  }

  /** @param {string} title */
  setTitle(title) {
    this.settings.title = title;
    this.#changed();
  }

  /** @param {keyof Speeds} name @param {number} value in SI units */
  setSpeed(name, value) {
    this.settings.speeds[name] = value;
    this.#changed();
  }

  /** @param {Control} control @param {string} name of the gesture */
  unbind(control, name) {
    const binding = this.#ownBinding(control);
    binding.gestures = binding.gestures.filter((one) => one !== name);
    this.#changed(true);
  }

  /** @param {Control} control @param {string} joint @param {1 | -1} direction */
  bind(control, joint, direction) {
    let gesture = gestureFor(this.settings.gestures, joint, direction);
    if (!gesture) {
      const twin = gestureFor(this.settings.gestures, joint, -direction);
      const mapped = this.profile.joints.find(({ name }) => name === joint);
      const suggested = twin ?? (mapped && (mapped[mapped.map] ?? mapped.pca));
      if (!suggested) return;
      gesture = {
        name: newGestureName(joint, direction),
        joint,
        direction,
        feature: "rate",
        dead_zone: suggested.dead_zone,
        full: suggested.full,
      };
      this.settings.gestures.push(gesture);
    }
    this.#ownBinding(control).gestures.push(gesture.name);
    this.#changed(true);
  }

  /** Send the changes that wait, at once. */
  async flush() {
    if (!this.#timer) return this.#sending;
    clearTimeout(this.#timer);
    this.#timer = 0;
    const body = structuredClone(this.settings);
    this.#sending = this.#sending.then(() => this.#put(body));
    return this.#sending;
  }

  /** Whether a change waits to be sent. */
  get isUnsent() {
    return this.#timer !== 0;
  }

  /** Drop the changes that were not sent: their session is no longer open. */
  drop() {
    clearTimeout(this.#timer);
    this.#timer = 0;
  }

  /** Undo, redo, suggest or load, and take the controls that the server answers. @param {() => Promise<ControlsView>} change */
  async ask(change) {
    await this.flush();
    this.#take(await change());
    this.dispatchEvent(new Event("shape"));
  }

  /** Read the controls again after a change from elsewhere; nothing happens when they and their obstacle are equal or a change of this page waits. */
  async readAgain() {
    if (this.#timer) return;
    await this.#sending;
    const view = await this.api.get("/controls");
    if (this.#timer) return;
    const before = this.view;
    if (view.hash !== before.hash) {
      this.#take(view);
      this.dispatchEvent(new Event("shape"));
    } else if (view.obstacle?.message !== before.obstacle?.message) {
      this.view = view;
      this.dispatchEvent(new Event("obstacle"));
    }
  }

  /** @param {ControlSettings} body */
  async #put(body) {
    try {
      const view = await this.api.put("/controls", body);
      if (this.#timer) this.view = view;
      else this.#take(view);
      this.dispatchEvent(new Event("saved"));
    } catch (error) {
      clearTimeout(this.#timer);
      this.#timer = 0;
      this.#take(this.view);
      this.dispatchEvent(new Event("shape"));
      this.dispatchEvent(new CustomEvent("refused", { detail: failureWords(error) }));
    }
  }

  /** @param {ControlsView} view */
  #take(view) {
    this.view = view;
    this.settings = settingsOf(view);
  }

  /** @param {Control} control */
  #ownBinding(control) {
    let binding = this.settings.bindings.find((one) => one.control === control);
    if (!binding) this.settings.bindings.push((binding = { control, gestures: [], gain: 1 }));
    return binding;
  }

  #changed(isShape = false) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.flush(), REST);
    this.dispatchEvent(new Event("saving"));
    if (isShape) this.dispatchEvent(new Event("shape"));
  }
}

/** A copy of what can be set: the parameters without the profile. @param {ControlsView} view @returns {Required<ControlSettings>} */
function settingsOf({ parameters }) {
  const { title, gestures, bindings, mode_u1, mode_u2, cutoff, cruise_time, turn_cruise_time, speeds } = parameters;
  const settings = { title, gestures, bindings, mode_u1, mode_u2, cutoff, cruise_time, turn_cruise_time, speeds };
  return /** @type {Required<ControlSettings>} */ (structuredClone(settings));
}
