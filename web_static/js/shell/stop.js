/** Stop: on pointer down, from the keyboard, and by the space bar while driving. Two ways at once, because one may be slow. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";

const SHOWN_FOR = 600; // ms that the button shows it was hit
const MOVING = new Set(["armed", "checking"]);

/** Send a stop over the socket and by HTTP; either is enough. @param {import("../main.js").App} app @param {"tablet" | "key"} by */
async function stopNow(app, by) {
  app.live.send({ stop: true, by });
  try {
    await app.api.post(by === "key" ? "/control/stop?by=key" : "/control/stop");
    app.toasts.announce(t("stop-sent"), true);
  } catch {
    if (!app.live.connected || app.live.age > 1) app.toasts.show(t("stop-not-sent"));
  }
}

/** Whether the page has a Stop: all but that of a reviewer elsewhere, who cannot see the chair. @param {import("../main.js").App} app */
const hasStop = ({ me, isNearby }) => isNearby || me?.role !== "reviewer";

/** The Stop button of the header, which pages have, signed in or not. @param {import("../main.js").App} app */
export function stopButton(app) {
  const button = h(
    "button",
    { type: "button", class: "stop", "aria-label": t("stop-label"), id: "stop" },
    h("span", {}, t("stop")),
  );
  const hit = () => {
    button.classList.add("sent");
    setTimeout(() => button.classList.remove("sent"), SHOWN_FOR);
    stopNow(app, "tablet");
  };
  button.addEventListener("pointerdown", hit);
  app.addEventListener("me", () => (button.hidden = !hasStop(app)));
  // A click without a pointer comes from the keyboard or from assistive technology.
  button.addEventListener("click", (event) => event.detail === 0 && hit());
  return button;
}

/**
 * Let the space bar stop while the chair is armed, whatever has the focus.
 * @param {import("../main.js").App} app @param {Window} where a window: ours, or the 3D view's
 * @param {AbortSignal} [signal]
 */
export function stopOnSpace(app, where, signal) {
  /** @param {KeyboardEvent} event */
  const stops = (event) => event.code === "Space" && hasStop(app) && mayMove(app) && !isWriting(event.target);
  /** @param {KeyboardEvent} event */
  const down = (event) => {
    if (!stops(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!event.repeat) stopNow(app, "key");
  };
  where.addEventListener("keydown", down, { capture: true, signal });
  // The button under the focus would be pressed when the key comes up.
  where.addEventListener(
    "keyup",
    (event) => event.code === "Space" && isDriven(app) && !isWriting(event.target) && event.preventDefault(),
    { capture: true, signal },
  );
}

/** Armed, being checked, or paused: then it goes on by itself. @param {import("../main.js").App} app */
function mayMove({ live: { latest } }) {
  return MOVING.has(latest?.state ?? "") || Boolean(latest?.trial?.paused);
}

/** @param {import("../main.js").App} app */
function isDriven({ live: { latest } }) {
  return Boolean(latest?.trial || latest?.drive);
}

/**
 * Tell whether a key belongs to a field that somebody writes into.
 * @param {EventTarget | null} target an element of this window or of the 3D view's, which has classes of its own
 */
export function isWriting(target) {
  const element = /** @type {Partial<Element> | null} */ (target);
  return element?.matches?.("input:not([type=radio]):not([type=checkbox]), textarea, select") ?? false;
}
