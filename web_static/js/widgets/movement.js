/**
 * Where the visitor wants the joints of the simulated body, from pads, keys and a gamepad together.
 * It goes to the body inside the shirt and nowhere else: the chair hears of it only through fabric, map and gate.
 */

const SEND_EVERY = 34; // ms: at most 30 messages a second
export const JOINTS = ["left_shoulder", "left_elbow", "right_elbow", "right_shoulder"];
/** @type {Record<string, string>} */
const KEYS = {
  KeyW: "right_elbow",
  ArrowUp: "right_elbow",
  KeyS: "left_elbow",
  ArrowDown: "left_elbow",
  KeyA: "right_shoulder",
  ArrowLeft: "right_shoulder",
  KeyD: "left_shoulder",
  ArrowRight: "left_shoulder",
};
// Standard gamepad: triggers are buttons 6 and 7; the sticks' vertical axes are 1 and 3, up is negative.
const TRIGGERS = { left_elbow: 6, right_elbow: 7 };
const STICKS = { left_shoulder: 1, right_shoulder: 3 };
const STICK_REST = 0.12; // a worn stick does not stand quite at 0
const TAKES_ARROWS = "input, select, textarea, [role=slider], [role=radio]";

/** @typedef {"pad" | "key" | "gamepad"} Source */

export class Movement extends EventTarget {
  /** @type {Record<Source, Map<string, number>>} */
  #levels = { pad: new Map(), key: new Map(), gamepad: new Map() };
  #sent = "";
  #timer = 0;

  /** @param {import("../live/live.js").Live} live @param {AbortSignal} signal */
  constructor(live, signal) {
    super();
    this.live = live;
    this.signal = signal;
    this.listenTo(window);
    live.addEventListener("connection", () => (this.#sent = ""), { signal });
    window.addEventListener("blur", () => this.#letGo("key"), { signal });
    this.#readGamepad();
    signal.addEventListener("abort", () => {
      for (const levels of Object.values(this.#levels)) levels.clear();
      this.#send();
    });
  }

  /** Listen to the keys of a window: the page's own, or that of the 3D view. @param {Window} where */
  listenTo(where) {
    /** @param {KeyboardEvent} event @param {number} level */
    const key = (event, level) => {
      const joint = KEYS[event.code];
      if (!joint || event.ctrlKey || event.metaKey || event.altKey || takesArrows(event.target)) return;
      event.preventDefault();
      if (!event.repeat) this.hold("key", joint, level);
    };
    where.addEventListener("keydown", (event) => key(event, 1), { signal: this.signal });
    where.addEventListener("keyup", (event) => key(event, 0), { signal: this.signal });
  }

  /** @param {Source} source @param {string} joint @param {number} level 0..1 */
  hold(source, joint, level) {
    if (level > 0) this.#levels[source].set(joint, level);
    else this.#levels[source].delete(joint);
    this.#changed();
  }

  /** @param {string} joint @returns {number} the strongest wish among the sources */
  level(joint) {
    return Math.max(0, ...Object.values(this.#levels).map((levels) => levels.get(joint) ?? 0));
  }

  /** @param {Source} source */
  #letGo(source) {
    this.#levels[source].clear();
    this.#changed();
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
    if (this.#timer) return;
    this.#send();
    this.#timer = setTimeout(() => {
      this.#timer = 0;
      this.#send();
    }, SEND_EVERY);
  }

  #send() {
    const move = Object.fromEntries(JOINTS.map((joint) => [joint, Number(this.level(joint).toFixed(3))]));
    const text = JSON.stringify(move);
    if (text === this.#sent) return;
    this.#sent = text;
    this.live.send({ move });
  }

  #readGamepad() {
    if (this.signal.aborted) return;
    const pad = navigator.getGamepads?.().find((one) => one?.connected && one.mapping === "standard");
    if (pad) {
      for (const [joint, button] of Object.entries(TRIGGERS)) this.#follow(joint, pad.buttons[button].value);
      for (const [joint, axis] of Object.entries(STICKS))
        this.#follow(joint, Math.max(0, -pad.axes[axis] - STICK_REST) / (1 - STICK_REST));
    } else if (this.#levels.gamepad.size) this.#letGo("gamepad");
    requestAnimationFrame(() => this.#readGamepad());
  }

  /** @param {string} joint @param {number} level of the gamepad, 0..1 */
  #follow(joint, level) {
    if (Math.abs((this.#levels.gamepad.get(joint) ?? 0) - level) > 0.005) this.hold("gamepad", joint, level);
  }
}

/** @param {EventTarget | null} target an element of this window or of the 3D view's, which has classes of its own */
function takesArrows(target) {
  const element = /** @type {Partial<Element> | null} */ (target);
  return Boolean(element?.closest?.(TAKES_ARROWS));
}
