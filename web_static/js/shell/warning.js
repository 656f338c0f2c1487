/**
 * What somebody has to look after soon, though nothing stops for it: a disk that fills up; for an owner, backups that
 * are no longer made.
 * @import { App } from "../main.js"
 */

/** Return the warning in words, and the page to go to where there is one. @param {App} app @returns {Promise<{words: string, href: string} | null>} */
export async function currentWarning(app) {
  const equipment = await app.api.get("/equipment").catch(() => null);
  if (equipment?.disk?.message) return { words: equipment.disk.message, href: "" };
  if (app.me?.role !== "owner") return null;
  const backups = await app.api.get("/backups").catch(() => null);
  return backups?.folder && backups.warning ? { words: backups.warning, href: "#/backup" } : null; // without a folder none was ever wanted
}
