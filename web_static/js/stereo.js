/** The stereo page: the patient's view for two eyes, shown to whoever may see it, and back by itself when it was lost. */
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
const LOOK_EVERY = 1500; // ms
const OLD = 3; // s: an older picture may have lost its connection
const PATIENCE = 15; // s for the first picture; after that somebody should know why there is none

class StereoPage {
  #root = h("main", { class: "stereo" });
  #api = new Api(() => {});
  #practice = practiceMark();
  #words = h("div", { class: "said", role: "status", hidden: true });
  /** @type {Eyes | null} */
  #eyes = null;
  #isRefused = false;
  #shown = new AbortController();
  #liveAt = 0;
  #isLost = false;

  start() {
    document.title = t("stereo.title");
    document.body.replaceChildren(this.#root, this.#practice.element);
    stayAwake();
    this.#look();
  }

  /** Look after the picture, again and again: one question at a time, and none while there is a picture. */
  async #look() {
    if (document.visibilityState === "visible") {
      readPractice(this.#api).then((kind) => this.#practice.show(kind), () => null); // lost: the picture says so
      if (this.#eyes?.age() < OLD) this.#liveAt = performance.now();
      if (!this.#eyes || this.#waited > OLD) await this.#ask();
      else this.#say("");
    }
    setTimeout(() => this.#look(), LOOK_EVERY);
  }

  /** For how long there has been no picture, s. */
  get #waited() {
    return (performance.now() - this.#liveAt) / 1000;
  }

  async #ask() {
    const may = await mayLook();
    if (may === null) {
      this.#isLost = true;
      this.#isRefused = false;
      this.#say("lost");
    } else if (may) {
      if (!this.#eyes) this.#show();
      else if (this.#isLost) this.#eyes.renew();
      this.#isLost = false;
      this.#say(this.#waited > PATIENCE ? "waiting" : "");
    } else if (!this.#isRefused) this.#leave();
  }

  #show() {
    this.#isRefused = false;
    const settings = new Settings();
    this.#shown = new AbortController();
    this.#liveAt = performance.now();
    this.#eyes = new Eyes(settings, this.#shown.signal);
    put(this.#root, this.#eyes.element, this.#words, controlBar(settings, this.#root, this.#shown.signal));
  }

  #leave() {
    this.#shown.abort();
    this.#eyes = null;
    this.#isRefused = true;
    put(
      this.#root,
      h(
        "section",
        { class: "refused", role: "status" },
        h("h1", {}, t("stereo.refused.title")),
        h("p", {}, t("stereo.refused.clinician"), " ", h("a", { href: "./" }, t("stereo.refused.sign-in"))),
        h("p", {}, t("stereo.refused.patient")),
      ),
    );
  }

  /** @param {"" | "lost" | "waiting"} what */
  #say(what) {
    if (!this.#words.isConnected) put(this.#root, this.#words);
    write(this.#words, what && t(`stereo.${what}`));
    this.#words.hidden = !what;
  }
}

/** Whether this browser may see the patient's view; null when nobody answers. */
async function mayLook() {
  const asked = new AbortController();
  try {
    const { ok, status } = await fetch(VIEW, { signal: asked.signal });
    if (ok) return true;
    return status === 401 || status === 403 ? false : null;
  } catch {
    return null;
  } finally {
    asked.abort(); // the page itself is not wanted here
  }
}

followSystem();
new StereoPage().start();
