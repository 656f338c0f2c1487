/** The live websocket: one per page, opened again by itself; the messages that it delivers. */
import { TypedEvents } from "./typed_events.js";
import { pagePictures } from "../view/frame_rate.js";

const FIRST_PAUSE = 250; // ms before trying again; doubled with each failure, up to ...
const LONGEST_PAUSE = 4000; // ms
const SILENT_AFTER = 1500; // ms without a message: at 20 a second the connection is dead, even if the socket looks open
const OPENING_LIMIT = 6000; // ms for a socket to open
const CHECK_EVERY = 100; // ms between two checks of the connection
const LATE_CHECK = 500; // ms between two checks when this page was busy
const SAY_LOST_AFTER = 700; // ms: a shorter gap is not reported
const SIGNED_OUT = 4401; // close code

/**
 * What the live sockets of clinicians and of the patient's screen have in common; lengths in m, angles in rad, times in s.
 * @typedef {object} Moment
 * @property {number} tick number of the tick; 0 while there is no control process
 * @property {number | null} t
 * @property {"disarmed" | "checking" | "armed" | "fault"} state
 * @property {string} control "alive", or why the control process does not answer
 * @property {number | null} v m/s
 * @property {(number | null)[]} pose x, y, heading
 * @property {number} contacts
 * @property {number} stops
 * @property {string | null} practice kind of the shirt in use when nobody wears it
 * @property {TestMoment | null} test
 * @property {string} [event] what changed on the server
 * @property {string[]} [quality] condition of each channel; sent once a second, as is `noise`
 * @property {(number | null)[]} [noise] of each channel, in units of its signal
 * @property {string} [shirt_words] the state of the shirt, sent with `quality`
 */

/**
 * @typedef {object} TrialMoment what a running trial is doing
 * @property {number} id
 * @property {number | null} waits s for which a halted or paused trial still waits; null: it is neither
 * @property {FaultWords | null} paused why it is paused, and goes on by itself
 * @property {number} pauses so far
 * @property {boolean} measuring whether it is over and is being measured
 * @property {number | null} t
 * @property {number | null} done m driven along the path
 * @property {number | null} length m of the path
 * @property {number | null} cross_track
 * @property {number | null} e_diff m²
 * @property {number | null} leader_distance
 * @property {(number | null)[][]} movers the pose of each
 * @property {(number | null)[] | null} leader its pose
 * @property {number} stage from 0
 * @property {number} stages
 * @property {import("../plan/floor_plan.js").Task["kind"]} kind
 * @property {string} title
 * @property {string} instruction
 * @property {number[]} target where the path ends
 */

/**
 * @typedef {object} TestMoment what a running two-minute test is doing; lengths in arms of its cross, ahead and to the left
 * @property {number} id
 * @property {"ready" | "running" | "over"} phase
 * @property {number | null} remaining s until the first target, then until the end
 * @property {(number | null)[]} cursor
 * @property {(number | null)[] | null} target
 * @property {number | null} radius of the target
 * @property {number | null} dwell share of the time for which the cursor must stay in the target, 0..1
 * @property {number} acquired
 * @property {number} missed
 */

/**
 * @typedef {object} ChairMoment what a real chair reports of itself
 * @property {string} kind
 * @property {"disarmed" | "checking" | "armed" | "fault"} state
 * @property {number | null} age of the report
 * @property {number | null} battery share
 * @property {boolean} stop_input
 * @property {number} v m/s
 * @property {number} omega rad/s
 * @property {string} words empty when there is nothing to say
 */

/** `remedy` is the next step without the word of the button. @typedef {{name: string, happened: string, next_step: string, remedy: string}} FaultWords */

/**
 * @typedef {object} ClinicianFields what only the clinician's socket tells
 * @property {FaultWords | null} fault
 * @property {number | null} u1
 * @property {number | null} u2
 * @property {number | null} omega rad/s
 * @property {number | null} scene_t
 * @property {{yaw: number | null, pitch: number | null, roll: number | null, age: number | null} | null} head
 * @property {boolean} in_contact
 * @property {string[]} gestures
 * @property {(number | null)[]} score of each gesture, as are `rate` and `activation`
 * @property {(number | null)[]} rate
 * @property {(number | null)[]} activation
 * @property {(number | null)[] | null} values of each channel in the newest frame
 * @property {{chosen: boolean, alive: boolean, sample_rate: number, lost: number, age: number | null}} shirt
 * @property {number} dial share of the speed limits
 * @property {ChairMoment | null} chair
 * @property {{kind: string, t: number | null, cue: number | null} | null} run
 * @property {TrialMoment | null} trial
 * @property {{id: number, t: number | null, waits: number | null} | null} drive
 * @property {number | null} session id of the open session
 * @property {boolean} hidden nothing of a patient is in this message: the page is locked, or the patient is not shown to this reviewer
 */

/** The clinician's live message. @typedef {Moment & ClinicianFields} LiveMessage */

/**
 * `open`: the socket is open. `tick`: a message came. `quality`: the condition of the channels came, once a second.
 * `changed`: something changed on the server; the detail names it. `connection`: the detail tells whether messages come.
 * @template Message
 * @typedef {object} LiveEvents
 * @property {Event} open
 * @property {CustomEvent<Message>} tick
 * @property {Event} quality
 * @property {CustomEvent<string>} changed
 * @property {CustomEvent<boolean>} connection
 */

/**
 * @template {Moment} [Message=LiveMessage]
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
    if (code === SIGNED_OUT) this.dispatchEvent(new CustomEvent("changed", { detail: "sign-in" }));
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
      this.dispatchEvent(new Event("quality"));
    }
    if (message.event === "graphics") this.#countPictures();
    else if (message.event) this.dispatchEvent(new CustomEvent("changed", { detail: message.event }));
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
    if (is) this.dispatchEvent(new CustomEvent("changed", { detail: "everything" }));
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
