/**
 * The application: who is signed in, who is here, the live link, and which page is shown.
 * @import { CurrentSession, EquipmentView, Me } from "types/api"
 * @import { Subject } from "./shell/subject.js"
 */
import { Api, ApiError, FORBIDDEN, failureWords } from "./api.js";
import { Live } from "./live/live.js";
import { giveFocus } from "./focus.js";
import { concerns } from "./live/news.js";
import { h, put } from "./widgets/dom.js";
import { LANGUAGE } from "./language.js";
import { chooseLanguage } from "./widgets/language_choice.js";
import { Lock } from "./shell/lock.js";
import { frameState } from "./shell/frame_state.js";
import { haltFollower } from "./shell/halt.js";
import { header } from "./shell/header.js";
import { DEMO_LINK, INVITATION_LINK, takeCode } from "./shell/link_codes.js";
import { firstTimePlace, notices } from "./shell/notices.js";
import { showWhetherOffline } from "./shell/offline.js";
import { PAGES } from "./shell/pages.js";
import { rail } from "./shell/rail.js";
import { stopOnSpace } from "./shell/stop.js";
import { pageTitle } from "./shell/subject.js";
import { followSystem } from "./shell/theme.js";
import { readReference } from "./reference.js";
import { questionPlace } from "./widgets/question.js";
import { Toasts } from "./shell/toast.js";
import { TypedEvents } from "./live/typed_events.js";
import { Screen } from "./live/screen.js";
import { PageSession } from "./live/page_session.js";
import { t } from "./texts.js";
import { currentWarning } from "./shell/warning.js";

const WARN_EVERY = 60_000; // ms

/**
 * What happens in the frame. `drafts`: the detail is a list to which a page adds what was entered and not sent;
 * `equipment`: the detail is the equipment after a file was added.
 * @typedef {{
 *   me: Event, session: Event, subject: Event, route: Event, "trial-view": Event, warning: Event, practice: Event,
 *   drafts: CustomEvent<string[]>, equipment: CustomEvent<EquipmentView>,
 * }} AppEvents
 */

/** @extends {TypedEvents<AppEvents>} */
export class App extends TypedEvents {
  /** The calls of the API, which name the session of the page; a page that is left keeps its own instance. */
  lock = new Lock(this);
  #onRefusal = { signedOut: () => this.signedOut(), locked: () => this.lock.lock() };
  api = new Api(this.#onRefusal);
  live = new Live();
  screen = new Screen();
  toasts = new Toasts();
  /** The stop or fault of a live message, with the further stops that this page has seen, wherever it is shown. */
  halt = haltFollower();
  question = questionPlace();
  /** The code of the link that was opened, until its person has chosen a password; otherwise empty. */
  invitation = "";
  /** Who is signed in here. @type {Me | null} */
  me = null;
  /** The open session and its patient. @type {CurrentSession | null} */
  session = null;
  #pageSession = new PageSession(this);
  /** Whether this page is in the building, where a person can see the chair. */
  isNearby = false;
  /** Whose data the page shows, where these are not simply those of the open session. @type {Subject | null} */
  subject = null;
  /** Kind of the shirt in use when nobody wears it. @type {string | null} */
  practice = null;
  /** What the address names: a page, and what it shall show. @type {{page: string, rest: string[]}} */
  route = { page: "", rest: [] };
  /** What somebody has to look after soon. @type {Awaited<ReturnType<typeof currentWarning>>} */
  warning = null;
  /** Whether the drive page shows a running trial or drive: then it shows faults itself. */
  showsTrial = false;
  /**
   * What changed since the page that is about to be shown began to read; null: it is shown.
   * @type {import("./live/news.js").News[] | null}
   */
  earlyNews = [];
  #leave = new AbortController();
  #shown = ""; // the address of the page that is shown
  /** @type {{floorplan: string, path: string} | null} the trial that the drive page shall start */
  #trialRequest = null;

  /** What header and rail follow. */
  state = frameState(this);
  root = h("main", { class: "page", tabindex: "-1" });
  rail = rail(this);
  frame = h(
    "div",
    { class: "app alone" },
    header(this),
    this.rail,
    h("div", { class: "above-page" }, notices(this), firstTimePlace(this)),
    this.root,
  );

  async start() {
    document.body.replaceChildren(
      this.frame,
      this.question,
      this.toasts.element,
      this.toasts.voice,
      this.toasts.urgent,
    );
    stopOnSpace(this, window);
    this.lock.watch();
    for (const event of /** @type {const} */ (["me", "session", "subject"])) {
      this.addEventListener(event, () => (document.title = pageTitle(this)));
    }
    this.live.addEventListener("changed", (event) => this.#changed(event.detail));
    this.live.addEventListener("connection", () => this.#connectionChanged());
    this.addEventListener("route", () => showWhetherOffline(this));
    this.live.addEventListener("tick", ({ detail }) => {
      this.#setPractice(detail.practice);
      this.lock.follow(detail.hidden);
      if (!this.lock.isLocked) this.#pageSession.follow(detail.session);
    });
    window.addEventListener("hashchange", () => this.show());
    setInterval(() => this.#lookForWarning(), WARN_EVERY);
    await this.enter();
  }

  /** Sign in by the demonstration's link if there is one, then show the first page. */
  async enter() {
    const code = takeCode(DEMO_LINK);
    if (code) await this.toasts.attempt(() => this.api.post("/auth/demo", { code }));
    const [start] = await Promise.all([
      this.toasts.attempt(() => this.api.get("/start")),
      readReference().catch(() => null), // the page that is shown reads it again
    ]);
    this.isNearby = start?.is_nearby ?? true;
    this.#setPractice(start?.practice ?? null);
    await this.#signedIn(start?.me ?? null, start?.session ?? null);
  }

  /** Take the answer of a sign-in. @param {Me} me */
  async signedIn(me) {
    await this.#signedIn(
      me,
      me.signed_in ? ((await this.toasts.attempt(() => this.api.get("/session"))) ?? null) : null,
    );
  }

  async signOut() {
    let words = "";
    await this.api.post("/auth/sign-out").catch((error) => (words = failureWords(error)));
    this.signedOut(words);
  }

  /** Nobody is signed in any more: remove at once what may name a patient. @param {string} [words] what to say then */
  signedOut(words = t("note-signed-out")) {
    if (!this.me?.signed_in) return;
    this.lock.lift();
    this.live.close();
    this.screen.close();
    this.api.forget();
    this.me = { ...this.me, signed_in: false };
    this.session = null;
    this.setSubject(null);
    put(this.root);
    this.toasts.clear();
    put(this.question);
    this.question.hidden = true;
    this.dispatchEvent(new Event("me"));
    this.show();
    if (words) this.toasts.show(words); // the page that was left has taken its messages with it
  }

  /** The page was unlocked: read what may have changed meanwhile; show the page when it was never there. */
  async unlocked() {
    await this.toasts.attempt(() => this.readSession());
    if (!this.root.hasChildNodes() || this.#readRoute() !== this.#shown) await this.show();
  }

  /** Read the open session again. @param {{isOwn?: boolean}} [options] isOwn: this page opened or ended it, and shows it from now on */
  async readSession({ isOwn = false } = {}) {
    this.session = await this.api.get("/session");
    if (isOwn) this.#pageSession.adopt();
    this.dispatchEvent(new Event("session"));
  }

  /** @param {string} hash like "#/drive" */
  go(hash) {
    if (location.hash === hash) this.show();
    else location.hash = hash;
  }

  /** Start a trial: the drive page prepares the picture first. @param {{floorplan: string, path: string}} where */
  requestTrial(where) {
    if (this.live.latest?.fault) {
      // A stop is taken back by Continue and by nothing else.
      this.toasts.show(t("note-fault-first"));
      /** @type {HTMLElement | null} */ (this.frame.querySelector(".note .btn"))?.focus();
      return;
    }
    // The page of the task has a button for what is missing.
    if (this.session?.obstacle) return this.go(`#/drive/task/${where.floorplan}/${where.path}`);
    this.#trialRequest = where;
    this.go("#/drive");
  }

  /** Return the requested trial and forget it. */
  takeTrialRequest() {
    const request = this.#trialRequest;
    this.#trialRequest = null;
    return request;
  }

  /** Tell the rest of the frame whether a trial or a drive has the page, and shows its faults itself. @param {boolean} is */
  setShowsTrial(is) {
    if (this.showsTrial === is) return;
    this.showsTrial = is;
    this.dispatchEvent(new Event("trial-view"));
  }

  /** Name in header and title whose data the page shows. @param {Subject | null} subject null: those of the open session */
  setSubject(subject) {
    this.subject = subject;
    this.dispatchEvent(new Event("subject"));
  }

  /** Show the page that the address names; without one, the page that comes next in this session. */
  async show() {
    if (this.lock.isLocked) return;
    this.#leave.abort();
    this.#pageSession.adopt();
    const leave = (this.#leave = new AbortController());
    const address = this.#readRoute();
    this.#shown = address;
    this.earlyNews = [];
    const { page: name, rest } = this.route;
    this.dispatchEvent(new Event("route"));
    this.setSubject(null);
    this.frame.classList.toggle("alone", !this.me?.signed_in);
    try {
      await readReference();
      const page = await import(`./pages/${name}/${name}.js`);
      if (leave.signal.aborted) return;
      this.setShowsTrial(false);
      this.root.className = "page";
      this.root.scrollTop = this.frame.scrollTop = 0; // where there is little height, the frame scrolls
      put(this.root, h("p", { class: "quiet" }, t("loading")));
      await page.show(this, this.root, { signal: leave.signal, rest });
    } catch (error) {
      if (!leave.signal.aborted) this.#failed(error);
    }
    if (leave.signal.aborted) return;
    this.earlyNews = null;
    this.#focusHeading();
  }

  /** The heading of a page that is shown has the focus, unless the page has given it to what it opened. */
  #focusHeading() {
    const { activeElement: now } = document;
    if (now === this.root || !this.root.contains(now)) this.root.querySelector("h1")?.focus({ preventScroll: true });
  }

  /** Read what the address names into `route`, and return it as one text. */
  #readRoute() {
    this.invitation = takeCode(INVITATION_LINK) || this.invitation;
    const [named, ...rest] = location.hash.replace(/^#\/?/, "").split("/");
    if (this.invitation) this.route = { page: "invitation", rest: [] };
    else if (!this.me?.signed_in) this.route = { page: this.me?.needs_setup ? "set_up" : "sign_in", rest: [] };
    else if (Object.hasOwn(PAGES, named)) this.route = { page: named, rest };
    else {
      this.route = { page: this.#next(), rest: [] };
      history.replaceState(null, "", `#/${this.route.page}`);
    }
    return [this.route.page, ...this.route.rest].join("/");
  }

  /** The page that comes next when the address names none. */
  #next() {
    if (this.me?.role === "reviewer") return "attention"; // looks, and changes nothing
    if (!this.session?.patient) return "patients";
    return this.session.has_profile ? "drive" : "calibrate";
  }

  /** Remove from the page what it shows of a patient who was deleted. @param {Subject} subject */
  #deleted({ code }) {
    this.leavePage();
    this.setSubject(null);
    put(
      this.root,
      h("h1", { tabindex: "-1" }, t("gone-title")),
      h("p", { class: "lead", role: "alert" }, t("gone-lead", { code })),
      h("div", {}, h("a", { class: "btn go", href: "#/patients" }, t("rail-patients"))),
    );
    giveFocus();
  }

  /** @param {unknown} error */
  #failed(error) {
    console.warn(error);
    this.setShowsTrial(false);
    const isForbidden = error instanceof ApiError && error.status === FORBIDDEN;
    const way = isForbidden
      ? h(
          "a",
          { class: "btn go", href: `#/${this.#next()}` },
          t("error-other-page", { page: t(`rail-${this.#next()}`) }),
        )
      : h("button", { type: "button", class: "btn go", onclick: () => this.show() }, t("try-again"));
    put(
      this.root,
      h("h1", { tabindex: "-1" }, t("error-page")),
      h("p", { class: "lead" }, failureWords(error)),
      h("div", {}, way),
    );
  }

  /** @param {Me | null} me @param {CurrentSession | null} session */
  async #signedIn(me, session) {
    this.me = me;
    this.session = session;
    this.dispatchEvent(new Event("session"));
    if (me?.signed_in) {
      if (me.language !== LANGUAGE) chooseLanguage(this, me.language); // of this person, who is new to this browser
      this.live.open();
      this.screen.open();
      this.#lookForWarning();
    }
    this.dispatchEvent(new Event("me"));
    if (me?.locked) this.lock.lock();
    await this.show();
  }

  async #lookForWarning() {
    if (!this.me?.signed_in) return;
    this.warning = await currentWarning(this);
    this.dispatchEvent(new Event("warning"));
  }

  #connectionChanged() {
    showWhetherOffline(this);
    // A page without the live socket does not see the chair, so its screen socket must not keep the chair driving.
    if (this.live.connected) return this.screen.open();
    this.screen.close();
    this.#whoAmI();
  }

  async #whoAmI() {
    const me = await this.api.get("/auth/me").catch(() => null);
    if (me && !me.signed_in) this.signedOut();
  }

  /** Send this session's id with each change from now on. @param {number | null} id */
  useSession(id) {
    this.api = new Api(this.#onRefusal, id);
  }

  /** End the page's listeners and requests. @param {string} [why] */
  leavePage(why) {
    this.#leave.abort(why);
  }

  /** @param {string | null} kind */
  #setPractice(kind) {
    if (this.practice === kind) return;
    this.practice = kind;
    this.dispatchEvent(new Event("practice"));
  }

  /** @param {import("./live/news.js").News} news of what changed on the server */
  #changed(news) {
    this.earlyNews?.push(news);
    if (news.what === "sign-in") this.#whoAmI();
    if (news.what === "deletion" && this.subject && news.patient === this.subject.patient) this.#deleted(this.subject);
    const patient = this.session?.patient?.id;
    const isOfSession =
      concerns(news, { what: ["session", "calibration", "controls", "equipment"] }) ||
      concerns(news, { what: ["trial", "consent"], patient });
    if (isOfSession && this.me?.signed_in) this.readSession().catch(() => null);
    if (concerns(news, { what: ["equipment", "trial", "disk", "backups"] })) this.#lookForWarning();
  }
}

followSystem();
new App().start();
