/** Short messages at the lower edge, with at most one thing to do about them; read out by screen readers. */
import { failureWords } from "../api.js";
import { giveFocus } from "../focus.js";
import { h } from "../widgets/dom.js";

const SHOWN_FOR = 8000; // ms: long enough to read it
const OFFERED_FOR = 20_000; // ms: long enough to reach for the tablet, or to come there with the keyboard

const SAID_FOR = 1000; // ms: then the same words are news again

/** Where toasts and announcements appear. */
export class Toasts {
  constructor() {
    this.element = h("div", { class: "toasts", role: "status" });
    this.voice = h("div", { class: "unseen", "aria-live": "polite" });
    this.urgent = h("div", { class: "unseen", "aria-live": "assertive" });
  }

  /**
   * @param {string} words
   * @param {{action?: string, run?: () => void}} [offer]
   */
  show(words, offer = {}) {
    const toast = h("div", { class: "toast" }, h("span", { class: "grow" }, words));
    let timer = 0;
    // Whoever is on its button is given the time to press it.
    const end = () => (toast.contains(document.activeElement) ? wait(SHOWN_FOR) : toast.remove());
    /** @param {number} pause */
    const wait = (pause) => (timer = setTimeout(end, pause));
    wait(offer.action ? OFFERED_FOR : SHOWN_FOR);
    if (offer.action) {
      const run = () => {
        clearTimeout(timer);
        this.#put();
        offer.run?.();
      };
      toast.append(h("button", { type: "button", onclick: run }, offer.action));
    }
    this.#put(toast);
  }

  /**
   * Show another message, or none; who is on the button of the one before goes on at the heading of the page.
   * @param {...Node} toast
   */
  #put(...toast) {
    const hadFocus = this.element.contains(document.activeElement);
    this.element.replaceChildren(...toast);
    if (hadFocus) giveFocus();
  }

  /**
   * Do what may be refused, and show why when it is.
   * @template T @param {() => T | Promise<T>} act @returns {Promise<T | undefined>} undefined when it was refused
   */
  async attempt(act) {
    try {
      return await act();
    } catch (error) {
      this.show(failureWords(error));
    }
  }

  /** Remove all messages: they were not meant for the next person at this screen. */
  clear() {
    this.#put();
    for (const place of [this.voice, this.urgent]) place.replaceChildren();
  }

  /** Say something to screen readers only; the same words within a second are said once. @param {string} words @param {boolean} [urgent] */
  announce(words, urgent = false) {
    const place = urgent ? this.urgent : this.voice;
    if (place.textContent === words) return;
    place.textContent = words;
    setTimeout(() => place.textContent === words && place.replaceChildren(), SAID_FOR);
  }
}
