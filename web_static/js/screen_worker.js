/**
 * The heartbeat of a screen, in a worker: it says over a socket of its own whether the page is in view.
 * The chair that this page armed stops after 300 ms of silence. When the page itself stands still, the worker says so.
 */

const SAY_EVERY = 50; // ms: twice the ten a second that are needed, because a busy machine delivers some of them late
const PAGE_LIMIT = 1000; // ms without a sign of life: nobody can be sure that this page shows anything
const FIRST_PAUSE = 50; // ms before the socket is opened again; doubled with each failure, up to ...
const LONGEST_PAUSE = 800; // ms
const OPENING_LIMIT = 2000; // ms for a socket to open

/** What the page said last. */
let page = { screen: "", visible: false, picture: "none", isWanted: false };
let heardAt = 0; // ms of performance.now
/** @type {WebSocket | null} */
let socket = null;
let pause = FIRST_PAUSE;
let openAgainAt = 0; // ms of performance.now
let askedAt = 0; // ms of performance.now, when the socket was asked for

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
  const visible = page.visible && now - heardAt < PAGE_LIMIT;
  socket.send(JSON.stringify({ screen: page.screen, visible, picture: page.picture }));
}

function connect(now) {
  const scheme = self.location.protocol === "https:" ? "wss" : "ws";
  const mine = new WebSocket(`${scheme}://${self.location.host}/api/v1/screen`);
  socket = mine;
  askedAt = now;
  mine.onopen = () => {
    if (mine !== socket) return;
    pause = FIRST_PAUSE;
    say(performance.now());
  };
  mine.onclose = () => lost(mine);
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
