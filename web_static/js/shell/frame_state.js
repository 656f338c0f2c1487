/**
 * What header and rail show, as signals that follow the events of the application.
 * @typedef {ReturnType<typeof frameState>} FrameState
 */
import { computed, signal } from "../preact.js";

/** @param {import("../main.js").App} app */
export function frameState(app) {
  const picture = signal(pictureOf(app.live)); // the newest of the live socket
  const me = signal(app.me);
  const session = signal(app.session);
  const subject = signal(app.subject);
  const practice = signal(app.practice);
  const page = signal(app.route.page);
  const isLocked = signal(app.lock.isLocked);
  const look = () => {
    picture.value = pictureOf(app.live);
    me.value = app.me;
    session.value = app.session;
    subject.value = app.subject;
    practice.value = app.practice;
    page.value = app.route.page;
    isLocked.value = app.lock.isLocked;
  };
  for (const event of /** @type {const} */ (["me", "session", "subject", "practice", "route"]))
    app.addEventListener(event, look);
  for (const event of /** @type {const} */ (["tick", "quality", "connection"])) app.live.addEventListener(event, look);
  const isConnected = computed(() => picture.value.isConnected);
  return { picture, isConnected, me, session, subject, practice, page, isLocked };
}

/** @param {import("../live/live.js").Live} live `present`: null while the socket is down */
function pictureOf({ latest, present, quality, connected: isConnected }) {
  return { latest, present, quality, isConnected };
}
