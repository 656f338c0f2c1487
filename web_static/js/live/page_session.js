/** The session that the page shows: requests of the page name it, and the page is covered when another one is open. */
import { changedFields, OTHER_SESSION, otherSession } from "../shell/other_session.js";
import { placeOf } from "../shell/pages.js";

/** @typedef {import("types/api").CurrentSession} CurrentSession */

export class PageSession {
  /** @type {CurrentSession | null} */
  #session = null;
  /** @type {HTMLElement | null} */
  #cover = null;
  #isAsking = false;
  #app;

  /** @param {import("../main.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** Show the open session from now on, and name it in each request that changes something. */
  adopt() {
    const app = this.#app;
    if (idOf(app.session) !== idOf(this.#session)) app.toasts.clear(); // their buttons belong to the earlier session
    this.#session = app.session;
    app.useSession(idOf(app.session));
    this.#cover?.remove();
    this.#cover = null;
    app.root.inert = false;
  }

  /**
   * Compare the open session with the page's; when they differ, cover the page or show the open one.
   * @param {number | null} id of the open session
   */
  async follow(id) {
    const app = this.#app;
    if (id === idOf(this.#session) || this.#cover || this.#isAsking || !app.me?.signed_in) return;
    this.#isAsking = true;
    try {
      await app.readSession();
    } catch {
      return; // the next tick asks again
    } finally {
      this.#isAsking = false;
    }
    const [before, now] = [this.#session, app.session];
    if (this.#cover || !now || idOf(now) === idOf(before)) return;
    if (before?.session && placeOf(app.route.page).ofSession) return this.#coverPage(before, now);
    this.adopt();
    if (app.root.querySelector(".body.empty")) app.show(); // the page says that nobody is here
  }

  /**
   * Cover the page of the earlier session, list the entries that were not sent, and send none of them.
   * @param {CurrentSession} before @param {CurrentSession} now
   */
  #coverPage(before, now) {
    const app = this.#app;
    const drafts = changedFields(app.root);
    app.dispatchEvent(new CustomEvent("drafts", { detail: drafts }));
    app.toasts.clear();
    app.api.end();
    app.leavePage(OTHER_SESSION);
    app.root.inert = true;
    const cover = otherSession(before, now, drafts, { onGo: () => app.show() });
    this.#cover = cover.element;
    app.root.after(cover.element);
    cover.focus();
  }
}

/** @param {CurrentSession | null} session @returns {number | null} */
function idOf(session) {
  return session?.session?.id ?? null;
}
