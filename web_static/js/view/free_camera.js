/** The free camera: turned, tilted, brought nearer and moved by drag, pinch, wheel, keys or buttons. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { repeatWhileHeld } from "../widgets/fields.js";
import { newestWins } from "../live/newest_wins.js";

const SEND_EVERY = 50; // ms: twenty times a second
const STEP = Math.PI / 24; // rad, of a button or key
const NEARER = 0.87; // of the distance, by a button or key
const DRAG = 0.006; // rad for a pixel
const WHEEL = 0.0015; // of the distance's logarithm for a pixel of the wheel
const MOVE = 0.0016; // of the distance for a pixel of two fingers
const KEY_MOVE = 40; // pixels that a key stands for
const LOW = { elevation: 0.05, distance: 1, place: -1000 };
const HIGH = { elevation: 1.57, distance: 100, place: 1000 };

const BUTTONS = [
  ["left", "⟲", (camera) => camera.turn(-STEP, 0)],
  ["right", "⟳", (camera) => camera.turn(STEP, 0)],
  ["up", "▲", (camera) => camera.turn(0, STEP)],
  ["down", "▼", (camera) => camera.turn(0, -STEP)],
  ["nearer", "+", (camera) => camera.zoom(NEARER)],
  ["farther", "−", (camera) => camera.zoom(1 / NEARER)],
];
const KEYS = {
  ArrowLeft: (camera, isMoved) => (isMoved ? camera.move(KEY_MOVE, 0) : camera.turn(-STEP, 0)),
  ArrowRight: (camera, isMoved) => (isMoved ? camera.move(-KEY_MOVE, 0) : camera.turn(STEP, 0)),
  ArrowUp: (camera, isMoved) => (isMoved ? camera.move(0, KEY_MOVE) : camera.turn(0, STEP)),
  ArrowDown: (camera, isMoved) => (isMoved ? camera.move(0, -KEY_MOVE) : camera.turn(0, -STEP)),
  "+": (camera) => camera.zoom(NEARER),
  "-": (camera) => camera.zoom(1 / NEARER),
};

/**
 * @param {(place: any) => Promise<any>} send tells the server where the camera is
 * @param {HTMLElement} surface what lies over the picture
 * @returns {{element: HTMLElement, open: (is: boolean, place?: any) => void}}
 */
export function freeCamera(send, surface) {
  const camera = new Orbit(newestWins(send, SEND_EVERY));
  const element = h(
    "div",
    { class: "hud free-pad", role: "group", "aria-label": t("trial.view.free.group"), hidden: true },
    BUTTONS.map(([name, sign, act]) => {
      const words = t(`trial.view.free.${name}`);
      const button = h("button", { type: "button", class: "btn small", "aria-label": words, title: words }, sign);
      repeatWhileHeld(button, () => act(camera));
      return button;
    }),
  );
  listen(surface, camera);
  const open = (is, place) => {
    if (place) camera.place = place;
    element.hidden = surface.hidden = !is;
  };
  return { element, open };
}

/** Where the camera is; each change is sent. */
class Orbit {
  /** @param {(place: any) => void} send */
  constructor(send) {
    this.send = send;
    this.place = null; // as the server has it
  }

  turn(azimuth, elevation) {
    const { place } = this;
    if (!place) return;
    const turned = place.azimuth + azimuth;
    this.#go({
      azimuth: Math.atan2(Math.sin(turned), Math.cos(turned)),
      elevation: within(place.elevation + elevation, "elevation"),
    });
  }

  zoom(share) {
    if (this.place) this.#go({ distance: within(this.place.distance * share, "distance") });
  }

  /** Let the picture follow fingers. @param {number} right pixels @param {number} down pixels */
  move(right, down) {
    const { place } = this;
    if (!place) return;
    const [sin, cos] = [Math.sin(place.azimuth), Math.cos(place.azimuth)];
    const scale = MOVE * place.distance;
    this.#go({
      x: within(place.x + scale * (right * sin - down * cos), "place"),
      y: within(place.y - scale * (right * cos + down * sin), "place"),
    });
  }

  #go(change) {
    this.place = { ...this.place, ...change };
    this.send(this.place);
  }
}

function listen(surface, camera) {
  const fingers = new Map();
  surface.addEventListener("mousedown", (event) => event.preventDefault()); // the keys stay with who had them
  surface.addEventListener("contextmenu", (event) => event.preventDefault());
  surface.addEventListener("pointerdown", (event) => {
    surface.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  surface.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
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
  for (const event of ["pointerup", "pointercancel", "lostpointercapture"])
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

function apart(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

function within(value, name) {
  return Math.min(HIGH[name], Math.max(LOW[name], value));
}
