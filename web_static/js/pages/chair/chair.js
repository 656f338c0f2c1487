/**
 * The real chair: what to look at before it is armed, the panel while it drives, what the drive came to.
 * @import { FullReading } from "./store.js"
 */
import { showArming } from "./arming.js";
import { showDrivePanel } from "./drive_panel.js";
import { showDriveSummary } from "./drive_summary.js";
import { readArming } from "./store.js";

const FIRST_PICTURE = 2000; // ms to wait for the live picture after the page was loaded

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  if (rest[1] === "over") return showDriveSummary(app, root, Number(rest[2]), signal);
  const [read] = await Promise.all([readArming(app.api), firstPicture(app.live)]);
  if (signal.aborted) return;
  /** @param {number} id */
  const drive = (id) => showDrivePanel(app, root, read, id, signal);
  if (app.live.latest?.drive) drive(app.live.latest.drive.id);
  else if (read.chair) showArming(app, root, /** @type {FullReading} */ (read), drive, signal);
  else location.replace("#/drive");
}

/** Wait for a live picture: it tells whether the chair is being driven. @param {import("../../live/live.js").Live} live */
function firstPicture(live) {
  if (live.latest) return null;
  return new Promise((resolve) => {
    live.addEventListener("tick", () => resolve(null), { once: true });
    setTimeout(() => resolve(null), FIRST_PICTURE);
  });
}
