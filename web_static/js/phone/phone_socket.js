/** The socket of a phone that is a sensor: opened again by itself, until the phone is unpaired or its page is opened elsewhere. */
import { LANGUAGE } from "../language.js";
import { REFERENCE } from "../reference.js";

/** @typedef {{number: number, wanted: boolean, part: string | null}} PhoneMessage what the server says twice a second */
/** @typedef {"elsewhere" | "unpaired"} End why the socket is not opened again */

const PAUSE = 1000; // ms before it is opened again
const SILENT_AFTER = 2000; // ms without a message, after which the machine counts as lost
const MOST_WAITING = 200; // bytes that wait to be sent: on a slow network only the newest sample counts

export class PhoneSocket {
  /** @type {WebSocket | null} */
  #socket = null;
  #retry = 0;
  #heardAt = -Infinity; // ms of performance.now
  #onMessage;
  #onEnd;

  /** @param {(message: PhoneMessage) => void} onMessage @param {(end: End) => void} onEnd called once */
  constructor(onMessage, onEnd) {
    this.#onMessage = onMessage;
    this.#onEnd = onEnd;
    this.#connect();
  }

  /** Whether the machine answers. */
  get isHeard() {
    return performance.now() - this.#heardAt < SILENT_AFTER;
  }

  /** Send a sample; drop it while the socket is not open, or still sends the ones before. @param {ArrayBuffer} sample */
  send(sample) {
    if (this.#socket?.readyState === WebSocket.OPEN && this.#socket.bufferedAmount < MOST_WAITING)
      this.#socket.send(sample);
  }

  close() {
    clearTimeout(this.#retry);
    const last = this.#socket;
    this.#socket = null;
    last?.close();
  }

  #connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/api/v1/phone?language=${LANGUAGE}`);
    this.#socket = socket;
    socket.onmessage = ({ data }) => {
      if (socket !== this.#socket) return;
      this.#heardAt = performance.now();
      this.#onMessage(JSON.parse(data));
    };
    socket.onclose = ({ code }) => {
      if (socket !== this.#socket) return;
      this.#socket = null;
      const { signed_out: signedOut, phone_elsewhere: elsewhere } = REFERENCE.numbers;
      if (code === signedOut || code === elsewhere) this.#onEnd(code === elsewhere ? "elsewhere" : "unpaired");
      else this.#retry = setTimeout(() => this.#connect(), PAUSE);
    };
  }
}
