/** The orientation of this tablet or phone as the head tracker: sent at most thirty times a second. */
import { h, signal } from "../../preact.js";
import { t } from "../../texts.js";

const EVERY = 1000 / 30; // ms
const RADIANS = Math.PI / 180;

const PATIENCE = 3000; // ms without an event after which there is no sensor

// The orientation is sent whichever page is shown.
const words = signal("");
/** What ends the sending; null: nothing is sent. */
const end = signal(/** @type {(() => void) | null} */ (null));

/** @param {{app: import("../../main.js").App}} tablet */
export function TabletHead({ app }) {
  const isOff = end.value !== null;
  const start = async () => {
    if (isOff) return;
    if (!window.isSecureContext) return void (words.value = t("head-tablet-insecure"));
    if (!("DeviceOrientationEvent" in window)) return void (words.value = t("head-tablet-none"));
    /** @type {typeof DeviceOrientationEvent & {requestPermission?: () => Promise<string>}} asked for by Safari */
    const sensor = window.DeviceOrientationEvent;
    const answer = sensor.requestPermission ? await sensor.requestPermission().catch(() => "denied") : "granted";
    if (answer !== "granted") return void (words.value = t("head-tablet-denied"));
    follow(app);
  };
  return h(
    "div",
    { class: "spread" },
    h(
      "button",
      { type: "button", class: "btn", "aria-disabled": isOff || undefined, onClick: start },
      t("head-tablet-start"),
    ),
    h("p", { class: "quiet small", role: "status" }, words.value),
  );
}

/** Stop sending the orientation: another tracker is used. */
export function endTabletHead() {
  end.value?.();
  words.value = "";
}

/** @param {import("../../main.js").App} app */
function follow(app) {
  endTabletHead();
  let last = -Infinity;
  /** @param {DeviceOrientationEvent} event */
  const send = ({ alpha, beta, gamma }) => {
    if (alpha === null || beta === null || gamma === null) return;
    clearTimeout(patience);
    const now = performance.now();
    if (now - last < EVERY) return;
    last = now;
    app.live.send({ look: orientation(alpha, beta, gamma, screen.orientation?.angle ?? 0) });
    words.value = t("head-tablet-tells");
  };
  const patience = setTimeout(() => {
    endTabletHead();
    words.value = t("head-tablet-none");
  }, PATIENCE);
  end.value = () => {
    clearTimeout(patience);
    window.removeEventListener("deviceorientation", send);
    end.value = null;
  };
  words.value = t("head-tablet-waiting");
  window.addEventListener("deviceorientation", send);
}

/**
 * Where the back of the screen looks: yaw left, pitch up, roll to the right positive (rad).
 * The angles are those of the W3C's Device Orientation: turns by alpha about z, beta about x, gamma about y.
 * @param {number} alpha @param {number} beta @param {number} gamma @param {number} turned how the picture is turned, degrees
 */
export function orientation(alpha, beta, gamma, turned) {
  const [ca, sa] = [Math.cos(alpha * RADIANS), Math.sin(alpha * RADIANS)];
  const [cb, sb] = [Math.cos(beta * RADIANS), Math.sin(beta * RADIANS)];
  const [cg, sg] = [Math.cos(gamma * RADIANS), Math.sin(gamma * RADIANS)];
  // Columns of the device's axes in the world (x east, y north, z up): its right, its top, its front.
  const right = [ca * cg - sa * sb * sg, sa * cg + ca * sb * sg, -cb * sg];
  const top = [-sa * cb, ca * cb, sb];
  const back = [-(ca * sg + sa * sb * cg), -(sa * sg - ca * sb * cg), -cb * cg];
  const [c, s] = [Math.cos(turned * RADIANS), Math.sin(turned * RADIANS)];
  const across = right.map((value, i) => c * value - s * top[i]); // the picture's right
  const up = right.map((value, i) => s * value + c * top[i]);
  const pitch = Math.asin(Math.min(1, Math.max(-1, back[2])));
  const yaw = Math.atan2(-back[0], back[1]);
  return { yaw, pitch, roll: Math.atan2(-across[2], up[2]) };
}
