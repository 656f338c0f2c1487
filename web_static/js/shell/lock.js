/**
 * The lock: the server locks a sign-in after some minutes without an action; then this covers the page, and keeps it.
 * Stop in the header stays. The page comes back, with what was typed, when the same person gives the password.
 * @import { Me } from "types/api"
 */
import { giveFocus } from "../focus.js";
import { h, render } from "../preact.js";
import { REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { h as element } from "../widgets/dom.js";
import { Field } from "../widgets/fields.js";
import { DoorForm } from "./door_form.js";
import { PasswordField } from "./password_field.js";

const TELL_EVERY = 10_000; // ms between two reports that the person does something
const ACTIONS = ["pointerdown", "keydown", "wheel"];

export class Lock {
  #app;
  #cover = element("main", { class: "page lock-page", tabindex: "-1" });
  #isHidden = false; // the server shows this page nothing of a patient: it is locked, or this reviewer may not see it
  #toldAt = -TELL_EVERY;
  isLocked = false;
  #before = /** @type {Element | null} */ (null); // what had the focus when the page was covered

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
    this.#before = document.activeElement;
    app.toasts.clear();
    app.question.style.display = "none";
    app.frame.classList.add("locked", "alone");
    render(this.#doors(), this.#cover);
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
    giveFocus(this.#before);
    render(null, this.#cover);
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
    /** @param {Record<string, string>} typed */
    const unlock = async ({ password }) => this.#open(await app.api.post("/auth/unlock", { password }));
    /** @param {Record<string, string>} typed */
    const enter = async ({ name, password }) => {
      const me = await app.api.post("/auth/sign-in", { name: name.trim(), password });
      app.signedOut("");
      await app.signedIn(me);
    };
    const autocomplete = "current-password";
    return h(
      "div",
      { class: "door card" },
      h("h1", { tabindex: -1 }, t("lock-title")),
      h("p", { class: "lead" }, t("lock-lead", { minutes: REFERENCE.numbers.lock_minutes })),
      h(
        DoorForm,
        { action: t("lock-open"), send: unlock },
        h(PasswordField, { label: t("lock-password", { name: app.me?.name }), autocomplete }),
      ),
      h(
        "details",
        {},
        h("summary", {}, t("lock-other")),
        h("p", { class: "quiet small" }, t("lock-other-lead", { name: app.me?.name })),
        h(
          DoorForm,
          { action: t("sign-in-go"), send: enter },
          h(
            Field,
            { label: t("sign-in-name") },
            h("input", { type: "text", name: "name", autocomplete: "username", required: true, maxlength: 80 }),
          ),
          h(PasswordField, { label: t("sign-in-password"), autocomplete }),
        ),
      ),
    );
  }
}
