/** What is shown while the server does not answer. */
import { placeOf } from "./pages.js";

/** Whether somebody is signed in, and the server does not answer. @param {import("../main.js").App} app */
const isOffline = (app) => Boolean(app.me?.signed_in) && !app.live.connected;

/** Whether the page needs the server, which does not answer. @param {import("../main.js").App} app */
export const isPageOff = (app) => isOffline(app) && !placeOf(app.route.page).withoutProgram;

/** While the server does not answer, mark the frame as offline and disable all pages but those that work without it. @param {import("../main.js").App} app */
export function showWhetherOffline(app) {
  app.frame.classList.toggle("offline", isOffline(app));
  app.rail.inert = isOffline(app);
  app.root.inert = isPageOff(app);
}
