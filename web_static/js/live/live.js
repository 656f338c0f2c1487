/** The live websocket: one per page, opened again by itself; the messages that it delivers. */
import { TypedEvents } from "./typed_events.js";
import { REFERENCE } from "../reference.js";
import { pagePictures } from "../view/frame_rate.js";

const FIRST_PAUSE = 250; // ms before trying again; doubled with each failure, up to ...
const LONGEST_PAUSE = 4000; // ms
const SILENT_AFTER = 1500; // ms without a message: at 20 a second the connection is dead, even if the socket looks open
const OPENING_LIMIT = 6000; // ms for a socket to open
const CHECK_EVERY = 100; // ms between two checks of the connection
const LATE_CHECK = 500; // ms between two checks when this page was busy
const SAY_LOST_AFTER = 700; // ms: a shorter gap is not reported

/**
 * @import { ArrivalsMoment, LiveMessage as Clinicians, News as ServerNews, PatientMessage as Patients, Quality } from "types/api"
 * @import { News } from "./news.js"
 * @typedef {Partial<Quality> & {news?: ServerNews}} Extras  the condition of the channels, once a second; what changed on the server
 * @typedef {Clinicians & Extras} LiveMessage
 * @typedef {Patients & Extras} PatientMessage
 */

/**
 * `open`: the socket is open. `tick`: a message came. `quality`: the condition of the channels came, once a second.
 * `changed`: something changed on the server; the detail says what. `connection`: the detail tells whether messages come.
 * @template Message
 * @typedef {object} LiveEvents
 * @property {Event} open
 * @property {CustomEvent<Message>} tick
 * @property {Event} quality
 * @property {CustomEvent<News>} changed
 * @property {CustomEvent<boolean>} connection
 */

/**
 * @template {LiveMessage | PatientMessage} [Message=LiveMessage]
 * @extends {TypedEvents<LiveEvents<Message>>}
 */
export class Live extends TypedEvents {
  /** @type {Message | null} the newest message */
  latest = null;
  /** @type {string[]} */
  quality = [];
  /** @type {(number | null)[]} */
  noise = [];
  shirtWords = "";
  /** @type {ArrivalsMoment | null} what arrives at the shirt; null: it does not say */
  arrivals = null;
  connected = true;
  /** @type {number} when the newest message came or the socket was asked for, in ms of performance.now */
  aliveAt = 0;
  /** @type {number} when the newest message came, in ms of the wall clock */
  receivedAt = 0;
  /** @type {WebSocket | null} */
  #socket = null;
  #pause = FIRST_PAUSE;
  #wanted = false;
  #lostTimer = 0;
  #retryTimer = 0;
  #checkedAt = 0;

  #path;

  /** @param {string} [path] of the socket on this server */
  constructor(path = "/api/v1/live") {
    super();
    this.#path = path;
    setInterval(() => this.#check(), CHECK_EVERY);
  }

  /** Open the socket and keep it open. */
  open() {
    if (this.#wanted) return;
    this.#wanted = true;
    this.receivedAt = Date.now();
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

  /** Send a message; drop it while the socket is not open. @param {object} message */
  send(message) {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(message));
  }

  /** The newest message; null while the socket is down, or before the first message. */
  get present() {
    return this.connected ? this.latest : null;
  }

  /** Seconds since the newest message. */
  get age() {
    return (performance.now() - this.aliveAt) / 1000;
  }

  #connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}${this.#path}`);
    this.#socket = socket;
    this.aliveAt = performance.now();
    socket.onopen = () => {
      this.aliveAt = performance.now();
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
    if (code === REFERENCE?.numbers.signed_out) this.#say({ what: "sign-in" });
    if (!this.#lostTimer) this.#lostTimer = setTimeout(() => this.#setConnected(false), SAY_LOST_AFTER);
    this.#retryTimer = setTimeout(() => this.#wanted && this.#connect(), this.#pause);
    this.#pause = Math.min(2 * this.#pause, LONGEST_PAUSE);
  }

  /** @param {Message} message */
  #take(message) {
    this.aliveAt = performance.now();
    this.receivedAt = Date.now();
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
      this.shirtWords = message.shirt_words ?? "";
      this.arrivals = message.arrivals ?? null;
      this.dispatchEvent(new Event("quality"));
    }
    if (message.news?.what === "graphics") this.#countPictures();
    else if (message.news) this.#say(message.news);
  }

  /** @param {News} news */
  #say(news) {
    this.dispatchEvent(new CustomEvent("changed", { detail: news }));
  }

  /** The server asks how many pictures a second this page draws, for the page "This computer". */
  async #countPictures() {
    this.send({ pictures: await pagePictures() });
  }

  /** @param {boolean} is */
  #setConnected(is) {
    if (is === this.connected) return;
    this.connected = is;
    this.dispatchEvent(new CustomEvent("connection", { detail: is }));
    // Changes during the gap were missed: everything is read again.
    if (is) this.#say({ what: "everything" });
  }

  #check() {
    const socket = this.#socket;
    if (!socket || document.visibilityState !== "visible") return;
    // After this page itself stood still, messages wait in its queue: process them before judging the connection.
    const isLate = performance.now() - this.#checkedAt > LATE_CHECK;
    this.#checkedAt = performance.now();
    if (isLate) return;
    const limit = socket.readyState === WebSocket.CONNECTING ? OPENING_LIMIT : SILENT_AFTER;
    if (performance.now() - this.aliveAt > limit) {
      socket.onclose = null;
      socket.close();
      this.#lost();
    }
  }
}
