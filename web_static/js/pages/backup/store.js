/**
 * What the page Backup shows, followed while a backup is being made.
 * @import { BackupsView } from "types/api"
 * @typedef {ReturnType<typeof backupStore>} BackupStore
 */
import { failureWords } from "../../api.js";
import { signal } from "../../preact.js";
import { t } from "../../texts.js";

const LOOK_EVERY = 1000; // ms

/** @param {import("../../main.js").App} app @param {BackupsView} first @param {AbortSignal} left */
export function backupStore(app, first, left) {
  const view = signal(first);
  let timer = 0;
  /** @param {BackupsView} now */
  const show = (now) => {
    clearTimeout(timer);
    if (view.value.course && !now.course) app.toasts.show(t(now.made[0]?.good ? "backup-done" : "backup-failed"));
    view.value = now;
    if (now.course && !left.aborted) timer = setTimeout(look, LOOK_EVERY);
  };
  const look = async () => {
    const before = view.value;
    const now = await app.api.get("/backups").catch(() => null);
    if (left.aborted || view.value !== before) return; // a newer answer is shown
    if (now) show(now);
    else timer = setTimeout(look, LOOK_EVERY);
  };
  /**
   * Send a change and show its answer; return why it was refused, otherwise "".
   * @param {() => Promise<BackupsView>} send
   */
  const change = async (send) => {
    try {
      show(await send());
      return "";
    } catch (error) {
      return failureWords(error);
    }
  };
  left.addEventListener("abort", () => clearTimeout(timer));
  show(first);
  return { app, view, show, change };
}
