/** The camera on a page: start and stop, a mirror with the joints that were found, and what to change. */
import { h, useLayoutEffect, useRef } from "../preact.js";
import { t } from "../texts.js";
import { advice, pose, rate, startCamera, status, stopCamera, stream } from "./camera.js";
import { isVisible } from "./channels.js";

const SLOWEST = 10; // pictures a second: with fewer, every channel is missing between two of them
const RUNNING = new Set(["asking", "preparing", "on"]);
/** The landmarks between which a line is drawn: face, arms, trunk. */
const LINES = [
  [7, 0],
  [0, 8],
  [11, 12],
  [11, 13],
  [13, 15],
  [12, 14],
  [14, 16],
  [11, 23],
  [12, 24],
  [23, 24],
];

export const isRunning = () => RUNNING.has(status.value);

/** What the camera does, or what to change, in a sentence. */
export function cameraWords() {
  if (status.value !== "on") return t(`camera-${status.value}`);
  if (advice.value !== "good") return t(`camera-${advice.value}`);
  return rate.value > 0 && rate.value < SLOWEST ? t("camera-slow", { count: rate.value }) : t("camera-good");
}

/** The card of the Shirt page while the camera is the shirt. */
export function CameraCard() {
  return h(
    "section",
    { class: "card", "data-card": "camera" },
    h("h2", {}, t("camera-title")),
    h("p", { class: "quiet small" }, t("camera-private")),
    stream.value && h(Mirror, {}),
    h("p", { role: "status" }, cameraWords()),
    status.value === "on" && h("p", { class: "quiet small" }, t("camera-rate", { count: rate.value })),
    isRunning()
      ? h("button", { type: "button", class: "btn", onClick: () => stopCamera() }, t("camera-stop"))
      : h("button", { type: "button", class: "btn go", onClick: startCamera }, t("camera-start")),
  );
}

/** The picture as in a mirror; it is shown, and neither stored nor sent. */
function Mirror() {
  const video = useRef(/** @type {HTMLVideoElement | null} */ (null));
  useLayoutEffect(() => {
    if (video.current) video.current.srcObject = stream.value;
  }, [stream.value]);
  return h(
    "div",
    { class: "camera-mirror", role: "img", "aria-label": t("camera-mirror") },
    h("video", { ref: video, autoplay: true, muted: true, playsInline: true, "aria-hidden": "true" }),
    h(Skeleton, {}),
  );
}

function Skeleton() {
  const landmarks = pose.value?.picture ?? [];
  return h(
    "svg",
    { viewBox: "0 0 1 1", preserveAspectRatio: "none", "aria-hidden": "true" },
    LINES.map(([from, to]) => {
      const [a, b] = [landmarks[from], landmarks[to]];
      if (!isVisible(a) || !isVisible(b)) return null;
      return h("path", { key: `${from}-${to}`, d: `M${a.x} ${a.y}L${b.x} ${b.y}` });
    }),
  );
}
