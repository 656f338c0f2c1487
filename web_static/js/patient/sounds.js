/** Soft sounds for a contact, the goal and a stop; told apart by their direction, so that nobody needs an ear for pitch. */

const LOUD = 0.22; // of full scale
const CONTACT_EVERY = 400; // ms: a chair that scrapes along a wall shall not rattle
/** Notes of each sound: frequency in Hz, its start and its length in s; a second frequency is where it glides to. */
const SOUNDS = Object.freeze({
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
});

export class Sounds {
  /** @type {AudioContext | null} */
  #context = null;
  #contactAt = -Infinity;

  /** Whether the browser lets this page be heard. */
  get isOn() {
    return this.#context?.state === "running";
  }

  /** Ask the browser: it agrees when somebody has just tapped. */
  async turnOn() {
    this.#context ??= new AudioContext();
    await this.#context.resume();
  }

  /** @param {keyof typeof SOUNDS} name */
  play(name) {
    if (!this.isOn) return;
    if (name === "contact") {
      if (performance.now() - this.#contactAt < CONTACT_EVERY) return;
      this.#contactAt = performance.now();
    }
    for (const note of SOUNDS[name]) this.#note(note);
  }

  #note({ from, to, start, length, type }) {
    const context = this.#context;
    const at = context.currentTime + start;
    const tone = new OscillatorNode(context, { type, frequency: from });
    const volume = new GainNode(context, { gain: 0 });
    tone.frequency.setValueAtTime(from, at);
    tone.frequency.exponentialRampToValueAtTime(to, at + length);
    volume.gain.setValueAtTime(0, at);
    volume.gain.linearRampToValueAtTime(LOUD, at + 0.02);
    volume.gain.exponentialRampToValueAtTime(0.001, at + length);
    tone.connect(volume).connect(context.destination);
    tone.start(at);
    tone.stop(at + length);
  }
}

/**
 * What is to be heard between two messages; nothing for the first one, whose past nobody saw.
 * @param {any} before @param {any} now @returns {(keyof typeof SOUNDS)[]}
 */
export function heard(before, now) {
  if (!before) return [];
  /** @type {(keyof typeof SOUNDS)[]} */
  const sounds = [];
  if (now.trial?.id === before.trial?.id && now.contacts > before.contacts) sounds.push("contact");
  if (now.over?.end === "goal" && now.over.id !== before.over?.id) sounds.push("goal");
  if (now.state === "fault" && before.state !== "fault") sounds.push("stop");
  return sounds;
}
