/** The stereo page: the patient's view for two eyes, for those who may see it; a lost view is loaded again. */
import { Api } from "./api.js";
import { h, put, write } from "./widgets/dom.js";
import { practiceMark, readPractice } from "./shell/practice_mark.js";
import { followSystem } from "./shell/theme.js";
import { stayAwake } from "./patient/wake.js";
import { controlBar } from "./stereo/bar.js";
import { Eyes } from "./stereo/eyes.js";
import { Settings } from "./stereo/settings.js";
import { t } from "./texts.js";

const VIEW = "/view/patient/";
const CHECK_EVERY = 1500; // ms
const OLD = 3; // s: an older picture may have lost its connection
const PATIENCE = 15; // s for the first picture; later the page says that it is waiting

class StereoPage {
  #root = h("main", { class: "stereo" });
  #api = new Api({ signedOut: () => {} });
  #practice = practiceMark();
  #words = h("div", { class: "said", role: "status", hidden: true });
  /** @type {Eyes | null} */
  #eyes = null;
  #isRefused = false;
  #picture = new AbortController();
  #liveAt = 0;
  #isLost = false;

  start() {
    document.title = t("stereo-title");
    document.body.replaceChildren(this.#root, this.#practice.element);
    stayAwake();
    this.#check();
  }

  /** Check the picture again and again; ask the server only while there is none, one request at a time. */
  async #check() {
    if (document.visibilityState === "visible") {
      const showPractice = (/** @type {string | null} */ kind) => this.#practice.show(kind);
      readPractice(this.#api).then(showPractice, () => null); // no answer: the check of the picture reports it
      if (this.#eyes && this.#eyes.age() < OLD) this.#liveAt = performance.now();
      if (!this.#eyes || this.#silence > OLD) await this.#ask();
      else this.#say("");
    }
    setTimeout(() => this.#check(), CHECK_EVERY);
  }

  /** The time (s) since the last picture. */
  get #silence() {
    return (performance.now() - this.#liveAt) / 1000;
  }

  async #ask() {
    const mayView = await isViewAllowed();
    if (mayView === null) {
      this.#isLost = true;
      this.#isRefused = false;
      this.#say("lost");
    } else if (mayView) {
      if (!this.#eyes) this.#show();
      else if (this.#isLost) this.#eyes.renew();
      this.#isLost = false;
      this.#say(this.#silence > PATIENCE ? "waiting" : "");
    } else if (!this.#isRefused) this.#leave();
  }

  #show() {
    this.#isRefused = false;
    const settings = new Settings();
    this.#picture = new AbortController();
    this.#liveAt = performance.now();
    this.#eyes = new Eyes(settings, this.#picture.signal);
    put(this.#root, this.#eyes.element, this.#words, controlBar(settings, this.#root, this.#picture.signal));
  }

  #leave() {
    this.#picture.abort();
    this.#eyes = null;
    this.#isRefused = true;
    put(
      this.#root,
      h(
        "section",
        { class: "refused", role: "status" },
        h("h1", {}, t("stereo-refused-title")),
        h("p", {}, t("stereo-refused-clinician"), " ", h("a", { href: "./" }, t("stereo-refused-sign-in"))),
        h("p", {}, t("stereo-refused-patient")),
      ),
    );
  }

  /** @param {"" | "lost" | "waiting"} what */
  #say(what) {
    if (!this.#words.isConnected) put(this.#root, this.#words);
    write(this.#words, what && t(`stereo-${what}`));
    this.#words.hidden = !what;
  }
}

/** Whether this browser may see the patient's view; null without an answer. */
async function isViewAllowed() {
  const request = new AbortController();
  try {
    const { ok, status } = await fetch(VIEW, { signal: request.signal });
    if (ok) return true;
    return status === 401 || status === 403 ? false : null;
  } catch {
    return null;
  } finally {
    request.abort(); // only the status is needed
  }
}

followSystem();
new StereoPage().start();
