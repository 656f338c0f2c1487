/** The patient's own screen as the camera: a button while the shirt in use is one, and what to change. */
import { isRunning, cameraWords } from "../camera/camera_card.js";
import { advice, startCamera, status } from "../camera/camera.js";
import { h, useComputed } from "../preact.js";
import { t } from "../texts.js";

/** @param {import("./screen.js").Newest} button */
export function CameraButton({ now }) {
  const isWanted = useComputed(() => now.value?.camera === true).value;
  const isSilent = !isWanted || status.value === "off" || (status.value === "on" && advice.value === "good");
  return [
    isWanted &&
      !isRunning() &&
      h("button", { type: "button", class: "btn camera", onClick: startCamera }, t("camera-start-screen")),
    h("p", { class: "hud camera-words", role: "status", hidden: isSilent }, isSilent ? "" : cameraWords()),
  ];
}
