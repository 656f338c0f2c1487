/**
 * The controls as they are being edited: changes show at once, are sent when the hand rests, and go back when refused.
 * Events: `shape` (draw again), `handles` (detail: the gesture whose handles moved), `saved`, `saving`, `refused` (detail: the server's sentence).
 */
import { gestureFor, newGestureName } from "../../widgets/gestures.js";

const REST = 400; // ms without another change, then it is sent
const SETTINGS = ["title", "gestures", "bindings", "mode_u1", "mode_u2", "cutoff", "cruise_time", "turn_cruise_time", "speeds"];
const LEAST_GAP = 0.02; // FS/s or FS

export class ControlsDraft extends EventTarget {
  #timer = 0;
  #sending = Promise.resolve();

  /** @param {import("../../api.js").Api} api @param {any} view what GET /controls answered */
  constructor(api, view) {
    super();
    this.api = api;
    this.#take(view);
  }

  get profile() {
    return this.view.parameters.profile;
  }

  get limits() {
    return this.view.limits;
  }

  binding(control) {
    return this.settings.bindings.find((binding) => binding.control === control) ?? { control, gestures: [], gain: 1 };
  }

  gesture(name) {
    return this.settings.gestures.find((gesture) => gesture.name === name);
  }

  /** @param {string} name @param {number} from @param {number} full */
  setHandles(name, from, full) {
    const gesture = this.gesture(name);
    gesture.dead_zone = Number(from.toFixed(4));
    gesture.full = Number(Math.max(full, from + LEAST_GAP).toFixed(4));
    this.dispatchEvent(new CustomEvent("handles", { detail: gesture }));
    this.#changed();
  }

  setFeature(name, feature) {
    this.gesture(name).feature = feature;
    this.#changed(true);
  }

  setGain(control, gain) {
    this.#ownBinding(control).gain = gain;
    this.#changed();
  }

  /** @param {"mode_u1" | "mode_u2" | "cutoff" | "cruise_time" | "turn_cruise_time" | "title"} name @param {any} value */
  setValue(name, value) {
    this.settings[name] = value;
    this.#changed(name.startsWith("mode"));
  }

  setSpeed(name, value) {
    this.settings.speeds[name] = value;
    this.#changed();
  }

  unbind(control, name) {
    const binding = this.#ownBinding(control);
    binding.gestures = binding.gestures.filter((one) => one !== name);
    this.#changed(true);
  }

  bind(control, joint, direction) {
    let gesture = gestureFor(this.settings.gestures, joint, direction);
    if (!gesture) {
      const twin = gestureFor(this.settings.gestures, joint, -direction);
      const suggested = twin ?? this.profile.joints.find(({ name }) => name === joint);
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

  /** Send what is waiting, now. */
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

  /** Drop the changes that wait: their session is no longer open. */
  drop() {
    clearTimeout(this.#timer);
    this.#timer = 0;
  }

  /** Undo, redo, suggest or load: what the server makes of it is taken. @param {string} path @param {any} [body] */
  async ask(path, body) {
    await this.flush();
    this.#take(await this.api.post(path, body));
    this.dispatchEvent(new Event("shape"));
  }

  /** Take what somebody else has changed, unless it is what we have. */
  async readAgain() {
    if (this.#timer) return;
    await this.#sending;
    const view = await this.api.get("/controls");
    if (view.hash === this.view.hash || this.#timer) return;
    this.#take(view);
    this.dispatchEvent(new Event("shape"));
  }

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
      this.dispatchEvent(new CustomEvent("refused", { detail: error.message }));
    }
  }

  #take(view) {
    this.view = view;
    this.settings = structuredClone(Object.fromEntries(SETTINGS.map((name) => [name, view.parameters[name]])));
  }

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
