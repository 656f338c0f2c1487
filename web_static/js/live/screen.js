/**
 * This page as a screen that may arm a chair: its identifying word, and its heartbeat.
 * The heartbeat is sent by a worker, a thread of its own, so that drawing cannot delay it; this module reports the page's
 * state to the worker.
 */

import { REFERENCE } from "../reference.js";

const REPORT_EVERY = 100; // ms between two reports to the worker
const STORAGE_KEY = "bodydrive-screen";

/** @typedef {import("./screen_worker.js").Picture} Picture */

export class Screen {
  /** A random word by which the server recognizes this screen. */
  word = pageWord();
  #isWanted = false;
  /** @type {Picture} */
  #picture = "none";
  #worker = new Worker(new URL("./screen_worker.js", import.meta.url), { type: "module" });

  constructor() {
    this.#worker.onmessage = () => {
      this.word = storeWord(randomWord()); // another page has the same word
      this.#report();
    };
    document.addEventListener("visibilitychange", () => this.#report());
    // A page that is left or suspended reports at once that it is out of view: later it cannot.
    window.addEventListener("pagehide", () => this.#report(false));
    window.addEventListener("pageshow", () => this.#report());
    setInterval(() => this.#report(), REPORT_EVERY);
  }

  /** Send heartbeats from now on. */
  open() {
    this.#isWanted = true;
    this.#report();
  }

  /** Send no more heartbeats, as after a sign-out. */
  close() {
    this.#isWanted = false;
    this.#report();
  }

  /** Report which picture this page shows. @param {Picture} picture */
  show(picture) {
    this.#picture = picture;
    this.#report();
  }

  #report(visible = document.visibilityState === "visible") {
    const inUse = REFERENCE?.numbers.screen_in_use ?? 0;
    /** @type {import("./screen_worker.js").ScreenReport} */
    const report = { screen: this.word, visible, picture: this.#picture, isWanted: this.#isWanted, inUse };
    this.#worker.postMessage(report);
  }
}

/** The word of this page: a reloaded page keeps its word, so that it drives on after Continue; another tab has another. */
function pageWord() {
  const [navigation] = performance.getEntriesByType("navigation");
  const isReload = navigation instanceof PerformanceNavigationTiming && navigation.type === "reload";
  return storeWord((isReload && sessionStorage.getItem(STORAGE_KEY)) || randomWord());
}

/** @param {string} word */
function storeWord(word) {
  sessionStorage.setItem(STORAGE_KEY, word);
  return word;
}

function randomWord() {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}
