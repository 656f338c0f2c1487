/**
 * The page of the patient's screen: paired by a link, shown during the session, with a word of thanks at its end.
 * @import { ComponentChildren } from "./preact.js"
 */
import { readReference } from "./reference.js";
import { Api, failureWords } from "./api.js";
import { LANGUAGE } from "./language.js";
import { Live } from "./live/live.js";
import { Fragment, h, render, useRef, useSignal } from "./preact.js";
import { Field } from "./widgets/fields.js";
import { practiceMark, readPractice } from "./shell/practice_mark.js";
import { followSystem } from "./shell/theme.js";
import { stopCamera } from "./camera/camera.js";
import { Screen } from "./patient/screen.js";
import { screenStore } from "./patient/store.js";
import { stayAwake } from "./patient/wake.js";
import { t } from "./texts.js";

const PAIR_LINK = /^#pair=(.+)$/;
const FIRST_PAUSE = 500; // ms before asking again; doubled with each failure, up to ...
const LONGEST_PAUSE = 5000; // ms

class PatientPage {
  #api = new Api({ signedOut: () => {} });
  /** @type {Live<import("./live/live.js").PatientMessage>} */
  #live = new Live(`/api/v1/patient/live?language=${LANGUAGE}`);
  #screen = new AbortController();
  #root = document.createElement("main");
  #practice = practiceMark();
  #isShowing = false;
  #pause = FIRST_PAUSE;
  #timer = 0;

  async start() {
    document.title = t("patient-title");
    this.#root.className = "patient";
    document.body.replaceChildren(this.#root, this.#practice.element);
    stayAwake();
    // After either event the pairing may have ended: ask the server for its state.
    this.#live.addEventListener("changed", ({ detail }) => detail.what === "sign-in" && this.#ask());
    this.#live.addEventListener("connection", () => !this.#live.connected && this.#ask());
    this.#live.addEventListener("tick", ({ detail }) => {
      this.#practice.show(detail.practice);
      useLanguage(detail.asks.language);
    });
    window.addEventListener("hashchange", () => this.enter());
    await this.enter();
  }

  /** Pair by the link if this page was opened by one, then show the state of the pairing. */
  async enter() {
    const link = PAIR_LINK.exec(location.hash);
    let words = "";
    if (link) {
      // The code must not stay in the address, where the next person could read it.
      history.replaceState(null, "", location.pathname);
      try {
        await this.#pair(decodeURIComponent(link[1]));
      } catch (error) {
        words = failureWords(error);
      }
    }
    await this.#ask(words);
  }

  /** @param {string} code */
  #pair(code) {
    return this.#api.post("/patient-screen/pair", { code });
  }

  async #ask(words = "") {
    clearTimeout(this.#timer);
    try {
      await readReference();
      const { state } = await this.#api.get("/patient-screen/me");
      this.#practice.show(await readPractice(this.#api));
      this.#pause = FIRST_PAUSE;
      if (state === "paired") this.#show();
      else this.#leave(state, words);
    } catch (error) {
      // While the screen is shown, its socket reconnects by itself.
      if (this.#isShowing) return;
      this.#say(t("patient-lost"), failureWords(error), t("patient-lost-why"));
      this.#timer = setTimeout(() => this.#ask(), this.#pause);
      this.#pause = Math.min(2 * this.#pause, LONGEST_PAUSE);
    }
  }

  #show() {
    if (this.#isShowing) return;
    this.#isShowing = true;
    this.#screen = new AbortController();
    this.#live.open();
    render(h(Screen, { store: screenStore(this.#root, this.#live, this.#screen.signal) }), this.#root);
  }

  /** @param {"over" | "unpaired" | "none"} state @param {string} words instead of the usual ones */
  #leave(state, words) {
    this.#isShowing = false;
    stopCamera();
    this.#screen.abort();
    this.#live.close();
    const form = h(CodeForm, { pair: (code) => this.#pair(code), onPaired: () => this.#ask() });
    this.#say(t(`patient-${state}-title`), words || t(`patient-${state}-lead`), t(`patient-${state}-next`), form);
  }

  /** @param {string} title @param {string} lead @param {string} next what to do @param {ComponentChildren} [form] */
  #say(title, lead, next, form) {
    const words = h(
      "section",
      { class: "calm", role: "status" },
      h("h1", {}, title),
      h("p", {}, lead),
      h("p", {}, next),
    );
    render(h(Fragment, {}, words, form), this.#root);
  }
}

/** Load the page again in the language that the clinician chose. @param {string | null} language null: the browser's */
function useLanguage(language) {
  const search = language ? `?language=${language}` : "";
  if (location.search !== search) location.replace(`${location.pathname}${search}`);
}

/**
 * For a screen without a camera: the code, typed.
 * @param {{pair: (code: string) => Promise<unknown>, onPaired: () => void}} form
 */
function CodeForm({ pair, onPaired }) {
  const code = useRef(/** @type {HTMLInputElement | null} */ (null));
  const problem = useSignal("");
  /** @param {Event} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.value = "";
    try {
      await pair(code.current?.value ?? "");
      onPaired();
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  return h(
    "form",
    { class: "code-form", onSubmit: submit },
    h(
      Field,
      { label: t("patient-code") },
      h("input", {
        type: "text",
        autocomplete: "off",
        autocapitalize: "characters",
        spellcheck: false,
        required: true,
        maxlength: 20,
        ref: code,
      }),
    ),
    h("button", { class: "btn go large" }, t("patient-code-go")),
    h("p", { class: "problem", role: "alert" }, problem),
  );
}

followSystem();
new PatientPage().start();
