/**
 * The lock: the server locks a sign-in after some minutes without an action; then this covers the page, and keeps it.
 * Stop in the header stays. The page comes back, with what was typed, when the same person gives the password.
 * @import { Me } from "types/api"
 */
import { failureWords } from "../api.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { h, put } from "../widgets/dom.js";
import { field } from "../widgets/fields.js";
import { passwordField } from "./password_field.js";

const TELL_EVERY = 10_000; // ms between two reports that the person does something
const ACTIONS = ["pointerdown", "keydown", "wheel"];

export class Lock {
  #app;
  #cover = h("main", { class: "page lock-page", tabindex: "-1" });
  #isHidden = false; // the server shows this page nothing of a patient: it is locked, or this reviewer may not see it
  #toldAt = -TELL_EVERY;
  isLocked = false;

  /** @param {import("../main.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** Report from now on what people do here, also inside the 3D view. */
  watch() {
    this.#watch(window);
    const load = (/** @type {Event} */ { target }) => {
      const inner = target instanceof HTMLIFrameElement ? target.contentWindow : null;
      if (inner) this.#watch(inner);
    };
    document.addEventListener("load", load, true); // a frame's load does not bubble
  }

  /** @param {Window} where */
  #watch(where) {
    for (const action of ACTIONS) where.addEventListener(action, () => this.#tell(), { capture: true, passive: true });
  }

  #tell() {
    if (this.isLocked || performance.now() - this.#toldAt < TELL_EVERY) return;
    this.#toldAt = performance.now();
    this.#app.live.send({ acted: true });
  }

  /** Take from the live socket whether it hides the patient. @param {boolean} isHidden */
  follow(isHidden) {
    if (isHidden === this.#isHidden) return;
    this.#isHidden = isHidden;
    this.#ask();
  }

  async #ask() {
    const me = await this.#app.api.get("/auth/me").catch(() => null);
    if (!me?.signed_in) return;
    if (me.locked) this.lock();
    else if (this.isLocked) await this.#open(me); // unlocked on another page of this browser
  }

  /** Cover the page; it stays as it is, out of sight. */
  lock() {
    const app = this.#app;
    if (this.isLocked || !app.me?.signed_in) return;
    this.isLocked = true;
    app.toasts.clear();
    app.question.style.display = "none";
    app.frame.classList.add("locked", "alone");
    put(this.#cover, this.#doors());
    app.root.replaceWith(this.#cover);
    app.dispatchEvent(new Event("me")); // the header names nobody now
    this.#cover.querySelector("input")?.focus({ preventScroll: true });
  }

  /** Put the page back. */
  lift() {
    const app = this.#app;
    if (!this.isLocked) return;
    this.isLocked = false;
    app.question.style.display = "";
    app.frame.classList.remove("locked", "alone");
    this.#cover.replaceWith(app.root);
    put(this.#cover);
    app.dispatchEvent(new Event("me"));
  }

  /** @param {Me} me */
  async #open(me) {
    this.#app.me = me;
    this.lift();
    await this.#app.unlocked();
  }

  #doors() {
    const app = this.#app;
    const password = h("input", { type: "password", autocomplete: "current-password", required: true });
    const name = h("input", { type: "text", autocomplete: "username", required: true, maxlength: 80 });
    const otherPassword = h("input", { type: "password", autocomplete: "current-password", required: true });
    const unlock = async () => this.#open(await app.api.post("/auth/unlock", { password: password.value }));
    const enter = async () => {
      const credentials = { name: name.value.trim(), password: otherPassword.value };
      const me = await app.api.post("/auth/sign-in", credentials);
      app.signedOut("");
      await app.signedIn(me);
    };
    return h(
      "div",
      { class: "door card" },
      h("h1", { tabindex: "-1" }, t("lock-title")),
      h("p", { class: "lead" }, t("lock-lead", { minutes: REFERENCE.numbers.lock_minutes })),
      form(unlock, t("lock-open"), passwordField(t("lock-password", { name: app.me?.name }), password)),
      h(
        "details",
        {},
        h("summary", {}, t("lock-other")),
        h("p", { class: "quiet small" }, t("lock-other-lead", { name: app.me?.name })),
        form(
          enter,
          t("sign-in-go"),
          field(t("sign-in-name"), name),
          passwordField(t("sign-in-password"), otherPassword),
        ),
      ),
    );
  }
}

/** @param {() => Promise<void>} act @param {string} words of its button @param {...HTMLElement} fields */
function form(act, words, ...fields) {
  const problem = h("p", { class: "problem", role: "alert" });
  const go = h("button", { class: "btn go large" }, words);
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    go.disabled = true; // a second tap would count as a second try
    await act().catch((error) => (problem.textContent = failureWords(error)));
    go.disabled = false;
  };
  return h("form", { class: "stack", onsubmit: submit }, fields, problem, go);
}
