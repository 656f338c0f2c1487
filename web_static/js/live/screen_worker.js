/**
 * The heartbeat of a screen, in a worker: it says over a socket of its own whether the page is in view, and for how long
 * the page's own thread has said nothing. The chair that this page armed stops after 300 ms without a word.
 */

const SAY_EVERY = 50; // ms: twice the ten a second that are needed, because a busy machine delivers some of them late
const FIRST_PAUSE = 50; // ms before the socket is opened again; doubled with each failure, up to ...
const LONGEST_PAUSE = 800; // ms
const OPENING_LIMIT = 2000; // ms for a socket to open
const TAKEN = 4409; // close code: another socket has the word of this page
const TAKEN_LIMIT = 5000; // ms of refusals: the server gives up a dead socket after 2 s, so the other socket belongs to a page that lives
const KEPT_AFTER = 500; // ms after which an open socket counts as accepted

/** What the page said last. */
let page = { screen: "", visible: false, picture: "none", isWanted: false };
let heardAt = 0; // ms of performance.now
/** @type {WebSocket | null} */
let socket = null;
let pause = FIRST_PAUSE;
let openAgainAt = 0; // ms of performance.now
let askedAt = 0; // ms of performance.now, when the socket was asked for
let openedAt = 0; // ms of performance.now
let refusedAt = 0; // ms of performance.now, when a socket was refused first; 0: none was

self.onmessage = ({ data }) => {
  const isNews = ["visible", "picture", "isWanted"].some((name) => data[name] !== page[name]);
  page = data;
  heardAt = performance.now();
  if (isNews) beat();
};
setInterval(beat, SAY_EVERY);

/** Say how things are; see that there is a socket as long as the page wants one. */
function beat() {
  const now = performance.now();
  if (!page.isWanted) return leave();
  if (!socket) {
    if (now >= openAgainAt) connect(now);
  } else if (socket.readyState === WebSocket.OPEN) say(now);
  else if (now - askedAt > OPENING_LIMIT) lost(socket);
}

function say(now) {
  if (now - openedAt > KEPT_AFTER) refusedAt = 0;
  const { screen, visible, picture } = page;
  socket.send(JSON.stringify({ screen, visible, silence: (now - heardAt) / 1000, picture }));
}

function connect(now) {
  const scheme = self.location.protocol === "https:" ? "wss" : "ws";
  const mine = new WebSocket(`${scheme}://${self.location.host}/api/v1/screen`);
  socket = mine;
  askedAt = now;
  mine.onopen = () => {
    if (mine !== socket) return;
    pause = FIRST_PAUSE;
    openedAt = performance.now();
    say(openedAt);
  };
  mine.onclose = ({ code }) => {
    if (code === TAKEN) refused(performance.now());
    lost(mine);
  };
}

/** Another page has the word of this one: ask for a new word. */
function refused(now) {
  refusedAt ||= now;
  if (now - refusedAt < TAKEN_LIMIT) return;
  refusedAt = 0;
  self.postMessage("taken");
}

/** @param {WebSocket} gone */
function lost(gone) {
  if (gone !== socket) return;
  leave();
  openAgainAt = performance.now() + pause;
  pause = Math.min(2 * pause, LONGEST_PAUSE);
}

function leave() {
  const left = socket;
  socket = null;
  left?.close();
}
