/**
 * The live websocket: one per page, coming back by itself.
 * Events: `open` (each new link), `tick` (each message), `quality` (once a second), `changed` (detail: what), `connection` (detail: is it there).
 */

const FIRST_PAUSE = 250; // ms before trying again; doubled with each failure, up to ...
const LONGEST_PAUSE = 4000; // ms
const SILENT_AFTER = 1500; // ms without a message: at 20 a second this is a dead link, even if the socket looks open
const OPENING_LIMIT = 6000; // ms for a socket to open
const LOOK_EVERY = 100; // ms between two looks at the link
const LATE_LOOK = 500; // ms between two looks: this page was busy
const SAY_LOST_AFTER = 700; // ms: a short gap is mended before anybody has to read about it
const SIGNED_OUT = 4401;

export class Live extends EventTarget {
  /** @type {any} the newest message */
  latest = null;
  /** @type {string[]} */
  quality = [];
  /** @type {(number | null)[]} */
  noise = [];
  connected = true;
  /** @type {number} when the newest message came or the socket was asked for, in ms of performance.now */
  heardAt = 0;
  /** @type {number} when the newest message came, in ms of the wall clock */
  saidAt = 0;
  #socket = null;
  #pause = FIRST_PAUSE;
  #wanted = false;
  #lostTimer = 0;
  #retryTimer = 0;
  #watchedAt = 0;

  #path;

  /** @param {string} [path] of the socket on this server */
  constructor(path = "/api/v1/live") {
    super();
    this.#path = path;
    setInterval(() => this.#watch(), LOOK_EVERY);
  }

  /** Open the socket and keep it open. */
  open() {
    if (this.#wanted) return;
    this.#wanted = true;
    this.saidAt = Date.now();
    this.#connect();
  }

  /** Close it for good, as when somebody signs out. */
  close() {
    this.#wanted = false;
    clearTimeout(this.#retryTimer);
    clearTimeout(this.#lostTimer);
    this.#socket?.close();
    this.#socket = null;
    this.latest = null;
  }

  /** Send a message; when the link is down it is dropped, never kept for later. @param {object} message */
  send(message) {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(message));
  }

  /** The newest message; null while the socket is down, or before the first message. */
  get present() {
    return this.connected ? this.latest : null;
  }

  /** Seconds since the newest message. */
  get age() {
    return (performance.now() - this.heardAt) / 1000;
  }

  #connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}${this.#path}`);
    this.#socket = socket;
    this.heardAt = performance.now();
    socket.onopen = () => {
      this.heardAt = performance.now();
      if (socket === this.#socket) this.dispatchEvent(new Event("open"));
    };
    socket.onmessage = (event) => {
      if (socket === this.#socket) this.#take(JSON.parse(event.data));
    };
    socket.onclose = (event) => {
      if (socket === this.#socket) this.#lost(event.code);
    };
  }

  #lost(code = 0) {
    this.#socket = null;
    if (!this.#wanted) return;
    if (code === SIGNED_OUT) this.dispatchEvent(new CustomEvent("changed", { detail: "sign-in" }));
    if (!this.#lostTimer) this.#lostTimer = setTimeout(() => this.#setConnected(false), SAY_LOST_AFTER);
    this.#retryTimer = setTimeout(() => this.#wanted && this.#connect(), this.#pause);
    this.#pause = Math.min(2 * this.#pause, LONGEST_PAUSE);
  }

  #take(message) {
    this.heardAt = performance.now();
    this.saidAt = Date.now();
    clearTimeout(this.#lostTimer);
    this.#lostTimer = 0;
    this.#pause = FIRST_PAUSE;
    this.#setConnected(true);
    if ("tick" in message) {
      this.latest = message;
      this.dispatchEvent(new CustomEvent("tick", { detail: message }));
    }
    if (message.quality) {
      this.quality = message.quality;
      this.noise = message.noise ?? [];
      this.dispatchEvent(new Event("quality"));
    }
    if (message.event) this.dispatchEvent(new CustomEvent("changed", { detail: message.event }));
  }

  #setConnected(is) {
    if (is === this.connected) return;
    this.connected = is;
    this.dispatchEvent(new CustomEvent("connection", { detail: is }));
    // What was missed meanwhile is read again.
    if (is) this.dispatchEvent(new CustomEvent("changed", { detail: "everything" }));
  }

  #watch() {
    const socket = this.#socket;
    if (!socket || document.visibilityState !== "visible") return;
    // When we ourselves stood still, messages wait in the queue: give them a turn first.
    const stoodStill = performance.now() - this.#watchedAt > LATE_LOOK;
    this.#watchedAt = performance.now();
    if (stoodStill) return;
    const limit = socket.readyState === WebSocket.CONNECTING ? OPENING_LIMIT : SILENT_AFTER;
    if (performance.now() - this.heardAt > limit) {
      socket.onclose = null;
      socket.close();
      this.#lost();
    }
  }
}
