/** The free camera: turned, tilted, brought nearer and moved by drag, pinch, wheel, keys or buttons. */
import { limitsOf } from "../reference.js";
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { repeatWhileHeld } from "../widgets/held_button.js";
import { newestWins } from "../live/newest_wins.js";

const SEND_EVERY = 50; // ms: twenty times a second
const STEP = Math.PI / 24; // rad, of a button or key
const NEARER = 0.87; // of the distance, by a button or key
const DRAG = 0.006; // rad for a pixel
const WHEEL = 0.0015; // of the distance's logarithm for a pixel of the wheel
const MOVE = 0.0016; // of the distance for a pixel of two fingers
const KEY_MOVE = 40; // pixels that a key stands for

/** @typedef {import("types/api").FreeCamera} CameraPlace where the camera stands and looks, as the server has it */

/** @type {[string, string, (camera: Orbit) => void][]} name, sign and act */
const BUTTONS = [
  ["left", "⟲", (camera) => camera.turn(-STEP, 0)],
  ["right", "⟳", (camera) => camera.turn(STEP, 0)],
  ["up", "▲", (camera) => camera.turn(0, STEP)],
  ["down", "▼", (camera) => camera.turn(0, -STEP)],
  ["nearer", "+", (camera) => camera.zoom(NEARER)],
  ["farther", "−", (camera) => camera.zoom(1 / NEARER)],
];
/** @type {Record<string, (camera: Orbit, moves: boolean) => void>} moves: the shift key is down */
const KEYS = {
  ArrowLeft: (camera, moves) => (moves ? camera.move(KEY_MOVE, 0) : camera.turn(-STEP, 0)),
  ArrowRight: (camera, moves) => (moves ? camera.move(-KEY_MOVE, 0) : camera.turn(STEP, 0)),
  ArrowUp: (camera, moves) => (moves ? camera.move(0, KEY_MOVE) : camera.turn(0, STEP)),
  ArrowDown: (camera, moves) => (moves ? camera.move(0, -KEY_MOVE) : camera.turn(0, -STEP)),
  "+": (camera) => camera.zoom(NEARER),
  "-": (camera) => camera.zoom(1 / NEARER),
};

/**
 * @param {(place: CameraPlace) => Promise<unknown>} send reports the camera's place to the server
 * @param {HTMLElement} surface what lies over the picture
 * @returns {{element: HTMLElement, open: (is: boolean, place?: CameraPlace) => void}}
 */
export function freeCamera(send, surface) {
  const camera = new Orbit(newestWins(send, SEND_EVERY));
  const element = h(
    "div",
    { class: "hud free-pad", role: "group", "aria-label": t("trial-view-free-group"), hidden: true },
    BUTTONS.map(([name, sign, act]) => {
      const words = t(`trial-view-free-${name}`);
      const button = h("button", { type: "button", class: "btn small", "aria-label": words, title: words }, sign);
      repeatWhileHeld(button, () => act(camera));
      return button;
    }),
  );
  listen(surface, camera);
  /** @param {boolean} is @param {CameraPlace} [place] */
  const open = (is, place) => {
    if (place) camera.place = place;
    element.hidden = surface.hidden = !is;
  };
  return { element, open };
}

/** The camera's place around what it looks at; each change is sent. */
class Orbit {
  /** @param {(place: CameraPlace) => void} send */
  constructor(send) {
    this.send = send;
    /** @type {CameraPlace | null} null until the server has answered */
    this.place = null;
  }

  /** @param {number} azimuth rad, a change @param {number} elevation rad, a change */
  turn(azimuth, elevation) {
    const { place } = this;
    if (!place) return;
    const turned = place.azimuth + azimuth;
    this.#go({
      ...place,
      azimuth: Math.atan2(Math.sin(turned), Math.cos(turned)),
      elevation: within(place.elevation + elevation, "elevation"),
    });
  }

  /** @param {number} ratio of the distance after to that before */
  zoom(ratio) {
    const { place } = this;
    if (place) this.#go({ ...place, distance: within(place.distance * ratio, "distance") });
  }

  /** Move the camera so that the picture follows the fingers. @param {number} right pixels @param {number} down pixels */
  move(right, down) {
    const { place } = this;
    if (!place) return;
    const [sin, cos] = [Math.sin(place.azimuth), Math.cos(place.azimuth)];
    const scale = MOVE * place.distance;
    this.#go({
      ...place,
      x: within(place.x + scale * (right * sin - down * cos), "x"),
      y: within(place.y - scale * (right * cos + down * sin), "y"),
    });
  }

  /** @param {CameraPlace} place */
  #go(place) {
    this.place = place;
    this.send(place);
  }
}

/** @param {HTMLElement} surface @param {Orbit} camera */
function listen(surface, camera) {
  /** The place of each finger in px, by its id. @type {Map<number, [number, number]>} */
  const fingers = new Map();
  surface.addEventListener("mousedown", (event) => event.preventDefault()); // the keyboard focus stays where it is
  surface.addEventListener("contextmenu", (event) => event.preventDefault());
  surface.addEventListener("pointerdown", (event) => {
    surface.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  surface.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    /** @type {[number, number]} */
    const now = [event.clientX, event.clientY];
    const [right, down] = [now[0] - before[0], now[1] - before[1]];
    fingers.set(event.pointerId, now);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      camera.zoom(apart(before, other) / Math.max(apart(now, other), 1));
      camera.move(right / 2, down / 2);
    } else if (event.shiftKey || event.buttons > 1) camera.move(right, down);
    else camera.turn(-DRAG * right, DRAG * down);
  });
  for (const event of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"]))
    surface.addEventListener(event, ({ pointerId }) => fingers.delete(pointerId));
  surface.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      camera.zoom(Math.exp(WHEEL * event.deltaY));
    },
    { passive: false },
  );
  surface.addEventListener("keydown", (event) => {
    const act = event.ctrlKey || event.metaKey || event.altKey ? null : KEYS[event.key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation(); // arrows drive when the focus is elsewhere
    act(camera, event.shiftKey);
  });
}

/** @param {[number, number]} a @param {[number, number]} b */
function apart(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** @param {number} value @param {keyof CameraPlace} name */
function within(value, name) {
  const { minimum, maximum } = limitsOf("FreeCamera", name);
  return Math.min(maximum ?? value, Math.max(minimum ?? value, value));
}
