/** Soft sounds for a contact, the goal and a stop; they differ in whether the pitch rises or falls, not in pitch alone. */

const LOUDNESS = 0.22; // of full scale
const CONTACT_EVERY = 400; // ms: a chair that scrapes along a wall repeats its contacts

/**
 * @typedef {{from: number, to: number, start: number, length: number, type: OscillatorType}} Note it glides from one
 *   frequency (Hz) to the other; start and length in s
 * @typedef {"contact" | "goal" | "stop"} SoundName
 */

/** @type {Record<SoundName, Note[]>} */
const SOUNDS = {
  contact: [{ from: 150, to: 70, start: 0, length: 0.22, type: "triangle" }],
  goal: [
    { from: 523, to: 523, start: 0, length: 0.28, type: "sine" },
    { from: 659, to: 659, start: 0.16, length: 0.28, type: "sine" },
    { from: 784, to: 784, start: 0.32, length: 0.5, type: "sine" },
  ],
  stop: [
    { from: 440, to: 440, start: 0, length: 0.24, type: "sine" },
    { from: 294, to: 294, start: 0.2, length: 0.5, type: "sine" },
  ],
};

export class Sounds {
  /** @type {AudioContext | null} */
  #context = null;
  #contactAt = -Infinity;

  /** Whether the browser lets this page make sounds. */
  get isOn() {
    return this.#context?.state === "running";
  }

  /** Ask the browser for permission, which it gives after a tap. */
  async turnOn() {
    this.#context ??= new AudioContext();
    await this.#context.resume();
  }

  /** @param {SoundName} name */
  play(name) {
    const context = this.#context;
    if (!context || !this.isOn) return;
    if (name === "contact") {
      if (performance.now() - this.#contactAt < CONTACT_EVERY) return;
      this.#contactAt = performance.now();
    }
    for (const note of SOUNDS[name]) playNote(context, note);
  }
}

/** @param {AudioContext} context @param {Note} note */
function playNote(context, { from, to, start, length, type }) {
  const at = context.currentTime + start;
  const tone = new OscillatorNode(context, { type, frequency: from });
  const volume = new GainNode(context, { gain: 0 });
  tone.frequency.setValueAtTime(from, at);
  tone.frequency.exponentialRampToValueAtTime(to, at + length);
  volume.gain.setValueAtTime(0, at);
  volume.gain.linearRampToValueAtTime(LOUDNESS, at + 0.02);
  volume.gain.exponentialRampToValueAtTime(0.001, at + length);
  tone.connect(volume).connect(context.destination);
  tone.start(at);
  tone.stop(at + length);
}

/**
 * The sounds for what happened between two messages; none for the first message.
 * @param {import("../live/live.js").PatientMessage | null} before @param {import("../live/live.js").PatientMessage} now
 * @returns {SoundName[]}
 */
export function soundsBetween(before, now) {
  if (!before) return [];
  /** @type {SoundName[]} */
  const sounds = [];
  if (now.trial?.id === before.trial?.id && now.contacts > before.contacts) sounds.push("contact");
  if (now.over?.end === "goal" && now.over.id !== before.over?.id) sounds.push("goal");
  if (now.state === "fault" && before.state !== "fault") sounds.push("stop");
  return sounds;
}
