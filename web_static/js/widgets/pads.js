/** Four pads for a visitor who is the body: hold one, and that joint of the simulated body moves. */
import { t } from "../texts.js";
import { h } from "./dom.js";
import { JOINTS, Movement } from "./movement.js";

const SIDES = { left: JOINTS.slice(0, 2), right: JOINTS.slice(2) };

/**
 * @param {import("../main.js").App} app @param {AbortSignal} signal
 * @param {{hasNote?: boolean}} [options]
 */
export function pads(app, signal, { hasNote = true } = {}) {
  const movement = new Movement(app.live, signal);
  const buttons = new Map(JOINTS.map((joint) => [joint, pad(joint, movement)]));
  const show = () =>
    buttons.forEach((button, joint) => {
      button.classList.toggle("held", movement.level(joint) > 0);
      button.style.setProperty("--level", String(movement.level(joint)));
    });
  movement.addEventListener("change", show);
  /** @param {keyof typeof SIDES} name */
  const side = (name) =>
    h(
      "div",
      { class: `pad-side ${name}` },
      SIDES[name].map((joint) => buttons.get(joint)),
    );
  const element = h(
    "div",
    { class: "pads", role: "group", "aria-label": t("pads-group") },
    side("left"),
    hasNote &&
      h("p", { class: "quiet small pad-note" }, t("pads-note"), " ", h("span", { class: "wide" }, t("pads-gamepad"))),
    side("right"),
  );
  return { element, movement };
}

/** @param {string} joint @param {Movement} movement */
function pad(joint, movement) {
  const verb = joint.endsWith("elbow") ? t("pads-bend") : t("pads-forward");
  const button = h(
    "button",
    { type: "button", class: "pad" },
    h("b", {}, t(`pads-${joint}`)),
    h("span", {}, verb),
    h("kbd", {}, t(`pads-keys-${joint}`)),
  );
  const release = () => movement.hold("pad", joint, 0);
  button.addEventListener("pointerdown", (event) => {
    button.setPointerCapture(event.pointerId);
    movement.hold("pad", joint, 1);
  });
  for (const event of ["pointerup", "pointercancel", "lostpointercapture", "blur"])
    button.addEventListener(event, release);
  button.addEventListener("contextmenu", (event) => event.preventDefault());
  button.addEventListener(
    "keydown",
    (event) => event.key === "Enter" && !event.repeat && movement.hold("pad", joint, 1),
  );
  button.addEventListener("keyup", (event) => event.key === "Enter" && release());
  return button;
}
