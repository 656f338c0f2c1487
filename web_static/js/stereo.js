/**
 * The stereo page: the patient's view for two eyes, for those who may see it; a lost view is loaded again.
 * @import { ReadonlySignal } from "./preact.js"
 */
import { Api } from "./api.js";
import { Fragment, h, render, signal } from "./preact.js";
import { practiceMark, readPractice } from "./shell/practice_mark.js";
import { followSystem } from "./shell/theme.js";
import { stayAwake } from "./patient/wake.js";
import { ControlBar } from "./stereo/bar.js";
import { Eyes, pictureAge } from "./stereo/eyes.js";
import { t } from "./texts.js";

/** @typedef {"" | "view" | "refused"} Shown empty: nothing yet, or nothing any more */
/** @typedef {"" | "lost" | "waiting"} Said */

const VIEW = "/view/patient/";
const CHECK_EVERY = 1500; // ms
const OLD = 3; // s: an older picture may have lost its connection
const PATIENCE = 15; // s for the first picture; later the page says that it is waiting

class StereoPage {
  #root = document.createElement("main");
  #api = new Api({ signedOut: () => {} });
  #practice = practiceMark();
  #shown = signal(/** @type {Shown} */ (""));
  #said = signal(/** @type {Said} */ (""));
  #round = signal(0); // in which both views are loaded
  #liveAt = 0;
  #isLost = false;

  start() {
    document.title = t("stereo-title");
    this.#root.className = "stereo";
    document.body.replaceChildren(this.#root, this.#practice.element);
    render(h(Page, { root: this.#root, shown: this.#shown, said: this.#said, round: this.#round }), this.#root);
    stayAwake();
    this.#check();
  }

  /** Check the picture again and again; ask the server only while there is none, one request at a time. */
  async #check() {
    if (document.visibilityState === "visible") {
      const showPractice = (/** @type {string | null} */ kind) => this.#practice.show(kind);
      readPractice(this.#api).then(showPractice, () => null); // no answer: the check of the picture reports it
      const isView = this.#shown.value === "view";
      if (isView && pictureAge() < OLD) this.#liveAt = performance.now();
      if (!isView || this.#silence > OLD) await this.#ask();
      else this.#said.value = "";
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
      if (this.#shown.value === "refused") this.#shown.value = "";
      this.#said.value = "lost";
    } else if (mayView) {
      if (this.#shown.value !== "view") this.#show();
      else if (this.#isLost) this.#round.value++;
      this.#isLost = false;
      this.#said.value = this.#silence > PATIENCE ? "waiting" : "";
    } else this.#shown.value = "refused";
  }

  #show() {
    this.#liveAt = performance.now();
    this.#shown.value = "view";
  }
}

/**
 * @param {{root: HTMLElement, shown: ReadonlySignal<Shown>, said: ReadonlySignal<Said>,
 *   round: ReadonlySignal<number>}} page
 */
function Page({ root, shown, said, round }) {
  if (shown.value === "refused") return h(Refused, {});
  const isView = shown.value === "view";
  return h(
    Fragment,
    {},
    isView && h(Eyes, { round: round.value }),
    h("div", { class: "said", role: "status", hidden: !said.value }, said.value && t(`stereo-${said.value}`)),
    isView && h(ControlBar, { root }),
  );
}

function Refused() {
  return h(
    "section",
    { class: "refused", role: "status" },
    h("h1", {}, t("stereo-refused-title")),
    h("p", {}, t("stereo-refused-clinician"), " ", h("a", { href: "./" }, t("stereo-refused-sign-in"))),
    h("p", {}, t("stereo-refused-patient")),
  );
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
