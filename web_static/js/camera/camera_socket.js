/** The socket of the page that is the camera: opened again by itself, until the server refuses this page. */
import { REFERENCE } from "../reference.js";

const PATH = "/api/v1/camera";
const PAUSE = 1000; // ms before it is opened again
const MOST_WAITING = 300; // bytes that wait to be sent: on a slow network only the newest sample counts
const NOT_A_SAMPLE = 1003; // close codes
const TOO_MANY = 1008;

/** @typedef {"taken" | "unwanted" | "failed" | "off"} Refusal off: the sign-in or the pairing has ended */

export class CameraSocket {
  /** @type {WebSocket | null} */
  #socket = null;
  #retry = 0;
  #onRefusal;

  /** @param {(refusal: Refusal) => void} onRefusal called once */
  constructor(onRefusal) {
    this.#onRefusal = onRefusal;
    this.#connect();
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
    const socket = new WebSocket(`${scheme}://${location.host}${PATH}`);
    this.#socket = socket;
    socket.onclose = ({ code }) => {
      if (socket !== this.#socket) return;
      this.#socket = null;
      const refusal = refusalOf(code);
      if (refusal) this.#onRefusal(refusal);
      else this.#retry = setTimeout(() => this.#connect(), PAUSE);
    };
  }
}

/** Null: the connection was lost. @param {number} code @returns {Refusal | null} */
function refusalOf(code) {
  const { signed_out: signedOut, camera_in_use: inUse, camera_unwanted: unwanted } = REFERENCE.numbers;
  if (code === signedOut) return "off";
  if (code === inUse) return "taken";
  if (code === unwanted) return "unwanted";
  return code === NOT_A_SAMPLE || code === TOO_MANY ? "failed" : null;
}
