/**
 * The heartbeat of a screen, in a worker: it reports over a socket of its own whether the page is in view, and how long ago
 * the page's own thread reported. The chair that this page armed stops after 300 ms without a heartbeat.
 */

const BEAT_EVERY = 50; // ms: twice the ten a second that are needed, because a busy machine delivers some of them late
const FIRST_PAUSE = 50; // ms before the socket is opened again; doubled with each failure, up to ...
const LONGEST_PAUSE = 800; // ms
const OPENING_LIMIT = 2000; // ms for a socket to open
// ms of refusals: the server gives up a dead socket after 2 s, so a socket that still has the word belongs to a live page
const REFUSAL_LIMIT = 5000;
const ACCEPTED_AFTER = 500; // ms after which an open socket counts as accepted

/**
 * What a page shows to drive by: the 3D view, the drawn plan, nothing, or a picture that is too old to drive by.
 * @typedef {"view" | "plan" | "none" | "late"} Picture
 * @typedef {object} ScreenReport from the page to this worker
 * @property {string} screen the page's word @property {boolean} visible @property {Picture} picture
 * @property {boolean} isWanted whether heartbeats are sent at all
 * @property {number} inUse the close code when another socket has that word
 */

/** The newest report of the page. @type {ScreenReport} */
let page = { screen: "", visible: false, picture: "none", isWanted: false, inUse: 0 };
let reportedAt = 0; // ms of performance.now
/** @type {WebSocket | null} */
let socket = null;
let pause = FIRST_PAUSE;
let openAgainAt = 0; // ms of performance.now
let requestedAt = 0; // ms of performance.now, when the socket was requested
let openedAt = 0; // ms of performance.now
let refusedAt = 0; // ms of performance.now, of the first refusal in a row; 0: none

/** @param {MessageEvent<ScreenReport>} event */
self.onmessage = ({ data }) => {
  const { visible, picture, isWanted } = page;
  const isNews = data.visible !== visible || data.picture !== picture || data.isWanted !== isWanted;
  page = data;
  reportedAt = performance.now();
  if (isNews) beat();
};
setInterval(beat, BEAT_EVERY);

/** Send a heartbeat; open a socket when the page wants one and there is none. */
function beat() {
  const now = performance.now();
  if (!page.isWanted) return leave();
  if (!socket) {
    if (now >= openAgainAt) connect(now);
  } else if (socket.readyState === WebSocket.OPEN) send(socket, now);
  else if (now - requestedAt > OPENING_LIMIT) reopen(socket);
}

/** @param {WebSocket} open @param {number} now ms of performance.now */
function send(open, now) {
  if (now - openedAt > ACCEPTED_AFTER) refusedAt = 0;
  const { screen, visible, picture } = page;
  open.send(JSON.stringify({ screen, visible, silence: (now - reportedAt) / 1000, picture }));
}

/** @param {number} now ms of performance.now */
function connect(now) {
  const scheme = self.location.protocol === "https:" ? "wss" : "ws";
  const mine = new WebSocket(`${scheme}://${self.location.host}/api/v1/screen`);
  socket = mine;
  requestedAt = now;
  mine.onopen = () => {
    if (mine !== socket) return;
    pause = FIRST_PAUSE;
    openedAt = performance.now();
    send(mine, openedAt);
  };
  mine.onclose = ({ code }) => {
    if (code === page.inUse) refuse(performance.now());
    reopen(mine);
  };
}

/** Another page has the word of this one: ask the page for a new word. @param {number} now ms of performance.now */
function refuse(now) {
  refusedAt ||= now;
  if (now - refusedAt < REFUSAL_LIMIT) return;
  refusedAt = 0;
  self.postMessage("word in use");
}

/** @param {WebSocket} gone */
function reopen(gone) {
  if (gone !== socket) return;
  leave();
  openAgainAt = performance.now() + pause;
  pause = Math.min(2 * pause, LONGEST_PAUSE);
}

function leave() {
  const last = socket;
  socket = null;
  last?.close();
}

export {}; // makes this file a module, so that screen.js can import its types
