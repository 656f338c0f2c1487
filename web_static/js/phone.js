/**
 * The page of a phone that is a sensor: paired by a link, started by a tap, then it sends how the phone is held.
 * @import { End, PhoneMessage } from "./phone/phone_socket.js"
 * @typedef {"unpaired" | "ready" | "sends" | "unwanted" | "lost" | "still" | "elsewhere"} State still: no sensor tells anything
 */
import { Api, failureWords } from "./api.js";
import { PhoneSocket } from "./phone/phone_socket.js";
import { LARGEST_PAGE, sampleOf } from "./phone/sample.js";
import { askForSensors, Sensor } from "./phone/sensor.js";
import { stayAwake } from "./patient/wake.js";
import { h, render, signal, useRef } from "./preact.js";
import { readReference } from "./reference.js";
import { followSystem } from "./shell/theme.js";
import { t } from "./texts.js";
import { Field } from "./widgets/fields.js";

const PAIR_LINK = /^#pair=(.+)$/;
const LEAST_PAUSE = 15; // ms between two samples: 60 a second, also on a screen with more pictures
const LOOK_EVERY = 250; // ms
const ASK_AGAIN = 2000; // ms after the machine did not answer
const MILLISECONDS = 1000;

class PhonePage {
  #api = new Api({ signedOut: () => {} });
  #root = document.createElement("main");
  #state = signal(/** @type {State} */ ("lost"));
  #problem = signal("");
  #told = signal(/** @type {PhoneMessage | null} */ (null));
  /** @type {PhoneSocket | null} */
  #socket = null;
  /** @type {Sensor | null} */
  #sensor = null;
  #page = newPage();
  #seq = 0;
  #sentAt = -Infinity; // ms of performance.now
  #request = 0; // of the next picture

  async start() {
    document.title = t("phone-title");
    window.addEventListener("hashchange", () => this.enter());
    document.addEventListener("visibilitychange", () => this.#resume());
    await this.enter();
    document.body.replaceChildren(this.#root);
    render(h(Page, { phone: this }), this.#root);
    setInterval(() => this.#look(), LOOK_EVERY);
  }

  get state() {
    return this.#state.value;
  }

  get problem() {
    return this.#problem.value;
  }

  /** What the server has said; null before. */
  get told() {
    return this.#told.value;
  }

  /** Pair by the link if this page was opened by one, then find out which phone this is. */
  async enter() {
    const link = PAIR_LINK.exec(location.hash);
    // The code must not stay in the address, where the next person could read it.
    if (link) history.replaceState(null, "", location.pathname);
    const isPaired = !link || (await this.#attempt(() => this.#pair(decodeURIComponent(link[1]))));
    await this.#ask(isPaired ? "" : this.problem);
  }

  /** @param {string} code typed */
  async pair(code) {
    if (await this.#attempt(() => this.#pair(code))) await this.#ask();
  }

  /** Begin to send; called by a tap, within which Safari asks for the sensors. */
  async send() {
    const permission = await askForSensors();
    if (permission !== "granted") return void (this.#problem.value = t(`phone-${permission}`));
    this.#problem.value = "";
    stayAwake();
    this.#sensor ??= new Sensor();
    this.#socket?.close();
    this.#socket = new PhoneSocket(
      (message) => void (this.#told.value = message),
      (end) => this.#end(end),
    );
    this.#state.value = "lost";
    this.#next();
  }

  /** @param {string} code */
  #pair(code) {
    return this.#api.post("/phones/pair", { code });
  }

  /** Find out which phone this is, until the machine answers. @param {string} [problem] that stays shown */
  async #ask(problem = "") {
    const isAnswered = await this.#attempt(async () => {
      await readReference();
      const { number } = await this.#api.get("/phones/me");
      this.#state.value = number === null ? "unpaired" : "ready";
    });
    if (!isAnswered) setTimeout(() => this.#ask(problem), ASK_AGAIN);
    else if (problem) this.#problem.value = problem;
  }

  /** Do something; show the sentence of its failure. @param {() => Promise<unknown>} act @returns {Promise<boolean>} whether it was done */
  async #attempt(act) {
    this.#problem.value = "";
    try {
      await act();
      return true;
    } catch (error) {
      this.#problem.value = failureWords(error);
      return false;
    }
  }

  /** Send with each picture of the page: a page that is not in view sends nothing. */
  #next() {
    cancelAnimationFrame(this.#request);
    if (!this.#socket) return;
    this.#request = requestAnimationFrame(() => {
      this.#sendNewest(performance.now());
      this.#next();
    });
  }

  /** Send the newest angles, if the sensor has told something since they were sent. @param {number} now ms */
  #sendNewest(now) {
    const sensor = this.#sensor;
    if (!sensor?.angles || sensor.toldAt <= this.#sentAt) return;
    if (!this.#told.peek()?.wanted || now - this.#sentAt < LEAST_PAUSE) return;
    this.#sentAt = now;
    this.#socket?.send(sampleOf(this.#page, this.#seq++, now / MILLISECONDS, sensor.angles));
  }

  /** Count as another page once this one is in view again: meanwhile the sensor was off, and may have another north. */
  #resume() {
    if (document.visibilityState === "visible") this.#page = newPage();
  }

  #look() {
    if (!this.#socket) return;
    if (!this.#socket.isHeard) this.#state.value = "lost";
    else if (!this.#sensor?.isHere) this.#state.value = "still";
    else this.#state.value = this.#told.peek()?.wanted ? "sends" : "unwanted";
  }

  /** @param {End} end */
  #end(end) {
    this.#socket?.close();
    this.#socket = null;
    this.#state.value = end;
  }
}

/** The number of a page: another one with each start of its sensor. */
function newPage() {
  return Math.floor(Math.random() * LARGEST_PAGE);
}

/** @param {{phone: PhonePage}} page */
function Page({ phone }) {
  const { state, problem, told } = phone;
  const isStart = state === "ready" || state === "elsewhere" || state === "still";
  return h(
    "section",
    { class: "phone", "data-state": state },
    told && h("p", { class: "quiet" }, t("phone-number", { number: told.number })),
    h("div", { role: "status" }, h("h1", {}, t(`phone-${state}`))),
    state === "sends" && h("p", { class: "part" }, told?.part ?? t("phone-no-part")),
    h("p", {}, t(`phone-${state}-lead`)),
    isStart && h("button", { type: "button", class: "btn go large", onClick: () => phone.send() }, t("phone-start")),
    state === "unpaired" && h(CodeForm, { phone }),
    h("p", { class: "problem", role: "alert" }, problem),
  );
}

/** For a phone whose camera reads no codes: the code, typed. @param {{phone: PhonePage}} form */
function CodeForm({ phone }) {
  const code = useRef(/** @type {HTMLInputElement | null} */ (null));
  /** @param {Event} event */
  const submit = (event) => {
    event.preventDefault();
    phone.pair(code.current?.value ?? "");
  };
  return h(
    "form",
    { onSubmit: submit },
    h(
      Field,
      { label: t("phone-code") },
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
    h("button", { class: "btn go large" }, t("phone-code-go")),
  );
}

followSystem();
new PhonePage().start();
