/**
 * This page as a screen that may arm a chair: its word, and the heartbeat that a worker sends for it.
 * The worker is a thread of its own, so that drawing cannot hold the heartbeat up; this side only tells it what is so.
 */

const SIGN_EVERY = 100; // ms between two signs of life to the worker
const WORD_PLACE = "bodydrive-screen";

export class Screen {
  /** A random word, by which the server knows this screen again. */
  word = wordOfThisPage();
  #isWanted = false;
  /** @type {"view" | "plan" | "none"} */
  #picture = "none";
  #worker = new Worker(new URL("./screen_worker.js", import.meta.url), { type: "module" });

  constructor() {
    this.#worker.onmessage = () => {
      this.word = keptWord(randomWord()); // another page has the word of this one
      this.#tell();
    };
    document.addEventListener("visibilitychange", () => this.#tell());
    // A page that is left, or put to sleep with its tab, is out of view before it can be asked.
    window.addEventListener("pagehide", () => this.#tell(false));
    window.addEventListener("pageshow", () => this.#tell());
    setInterval(() => this.#tell(), SIGN_EVERY);
  }

  /** Say that this page is here, from now on. */
  open() {
    this.#isWanted = true;
    this.#tell();
  }

  /** Say nothing any more, as when somebody signs out. */
  close() {
    this.#isWanted = false;
    this.#tell();
  }

  /** Say what this page shows to drive by. @param {"view" | "plan" | "none"} picture */
  show(picture) {
    this.#picture = picture;
    this.#tell();
  }

  #tell(visible = document.visibilityState === "visible") {
    this.#worker.postMessage({ screen: this.word, visible, picture: this.#picture, isWanted: this.#isWanted });
  }
}

/** A page that was loaded again is still the screen that it was: after Continue it drives on. Another tab is another screen. */
function wordOfThisPage() {
  const isReload = performance.getEntriesByType("navigation")[0]?.type === "reload";
  return keptWord((isReload && sessionStorage.getItem(WORD_PLACE)) || randomWord());
}

function keptWord(word) {
  sessionStorage.setItem(WORD_PLACE, word);
  return word;
}

function randomWord() {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
