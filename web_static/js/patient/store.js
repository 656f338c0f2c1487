/**
 * What the patient's screen shows: the newest message, and what lasts longer than one.
 * @import { PatientFault } from "types/api"
 * @import { Live, PatientMessage } from "../live/live.js"
 * @import { Further } from "../shell/halt.js"
 * @import { MomentWord } from "./moment_word.js"
 * @typedef {Live<PatientMessage>} PatientLive
 * @typedef {ReturnType<typeof screenStore>} ScreenStore
 */
import { signal } from "../preact.js";
import { haltFollower } from "../shell/halt.js";
import { momentWords } from "./moment_word.js";
import { Sounds, soundsBetween } from "./sounds.js";

/** @param {HTMLElement} root @param {PatientLive} live @param {AbortSignal} left of the screen */
export function screenStore(root, live, left) {
  const now = signal(/** @type {PatientMessage | null} */ (null));
  const moment = signal({ word: /** @type {MomentWord} */ (""), waits: "" }); // waits: what was waited for as it came
  const halt = signal(/** @type {(PatientFault & Further) | null} */ (null)); // another one with each further stop
  const isConnected = signal(live.connected);
  const isMute = signal(false); // there shall be sounds, and the browser lets this page make none
  const wordOf = momentWords();
  const haltOf = haltFollower();
  const sounds = new Sounds();
  /** @param {PatientMessage} message */
  const show = (message) => {
    const { state, fault, stops, waits, asks } = message;
    const before = now.value;
    now.value = message;
    const word = wordOf(message, performance.now());
    if (word !== moment.value.word) moment.value = { word, waits: waits.message };
    const newest = haltOf(state === "fault" ? fault : null, stops);
    if (newest?.key !== halt.value?.key) halt.value = newest;
    document.documentElement.classList.toggle("large", asks.large);
    isMute.value = asks.sounds && !sounds.isOn;
    if (asks.sounds) for (const name of soundsBetween(before, message)) sounds.play(name);
  };
  const showConnection = () => {
    isConnected.value = live.connected;
    root.classList.toggle("is-lost", !live.connected);
  };
  const turnSoundOn = async () => {
    await sounds.turnOn();
    isMute.value = !sounds.isOn;
  };
  live.addEventListener("tick", ({ detail }) => show(detail), { signal: left });
  live.addEventListener("connection", showConnection, { signal: left });
  left.addEventListener("abort", () => root.classList.remove("is-lost")); // what the page shows next is up to date
  showConnection();
  return { live, left, now, moment, halt, isConnected, isMute, turnSoundOn };
}
