/**
 * The patient's screens of this session: pair one by a code, what they show, unpair one.
 * @import { OfferView, ScreensView, ScreenView, ScreenSettings } from "types/api"
 */
import { concerns } from "../live/news.js";
import { t } from "../texts.js";
import { copyText } from "./clipboard.js";
import { h, put, write } from "./dom.js";
import { field, selection, toggle } from "./fields.js";
import { moment } from "./format.js";
import { icon } from "./icons.js";
import { languageOptions } from "./language_choice.js";
import { rowList } from "./list.js";
import { pictureOf } from "./one_time_key.js";

const WISHES = /** @type {const} */ (["arrow", "sounds", "large", "plan"]);
const LOOK_EVERY = 5000; // ms between two looks at the time that a code has left
const MINUTE = 60_000; // ms

/**
 * @param {import("../main.js").App} app @param {AbortSignal} signal
 * @param {{isPage?: boolean}} [options] on a page of its own, the page has the heading
 */
export async function patientScreenCard(app, signal, { isPage = false } = {}) {
  const list = rowList("paired-chairs");
  const wishes = h("div", { class: "spread" });
  const below = h("div", {});
  const element = h(
    "section",
    { class: "card patient-screens" },
    !isPage && h("h2", {}, t("screens-title")),
    !isPage && h("p", { class: "quiet small" }, t("screens-lead")),
    list,
    wishes,
    below,
  );
  let isOpen = false; // a code is shown
  /** @type {ScreensView | null} */
  let shown = null;

  /** @param {ScreensView} read */
  const draw = (read) => {
    const before = shown;
    if (isOpen && before && read.screens.some(({ id }) => !before.screens.some((screen) => screen.id === id))) {
      app.toasts.show(t("screens-paired"));
      offer();
    }
    shown = read;
    list.show(read.screens.map(row));
    const hadFocus = wishes.contains(document.activeElement);
    const at = [...wishes.querySelectorAll("input, select")].findIndex((input) => input === document.activeElement);
    put(
      wishes,
      WISHES.map((wish) => toggle(t(`screens-${wish}`), read.settings[wish], (on) => choose({ [wish]: on }))),
      languageOf(read.settings),
    );
    if (hadFocus) /** @type {NodeListOf<HTMLElement>} */ (wishes.querySelectorAll("input, select"))[at]?.focus();
  };
  /** @param {ScreenSettings} settings */
  const languageOf = ({ language }) => {
    const languages = app.me?.languages ?? [];
    if (languages.length < 2) return null;
    const options = [{ value: "", label: t("language-of-browser") }, ...languageOptions(languages)];
    const select = selection(options, language ?? "", (chosen) => choose({ language: chosen || null }));
    return field(t("language-screen"), select);
  };
  /** Draw what a call answers. @param {Promise<ScreensView>} answer @returns {Promise<boolean | undefined>} whether it was done */
  const call = (answer) =>
    app.toasts.attempt(async () => {
      draw(await answer);
      return true;
    });
  const read = () => {
    if (app.session?.patient) return call(app.api.get("/patient-screen"));
    shown = null;
    list.show([]);
    put(wishes);
    put(below, h("p", { class: "quiet" }, t("screens-nobody")));
  };
  /** @type {Promise<unknown>} */
  let sent = Promise.resolve();
  /** Send one choice after the other: each adds to what the answer before it says. @param {Partial<ScreenSettings>} change */
  const choose = (change) => {
    const session = app.session?.session?.id;
    sent = sent.then(async () => {
      if (!shown || app.session?.session?.id !== session) return; // meant for somebody who is not here any more
      const settings = { ...shown.settings, ...change };
      (await call(app.api.post("/patient-screen/settings", settings))) || (await read());
    });
  };
  /** @param {ScreenView} screen */
  const unpair = async ({ id, number }) => {
    if (await call(app.api.remove(`/patient-screen/${id}`))) app.toasts.show(t("screens-unpaired", { number }));
  };
  /** @param {ScreenView} screen */
  const row = (screen) => {
    const label = t("screens-unpair-label", { number: screen.number });
    const action = { type: "button", class: "btn", "aria-label": label, onclick: () => unpair(screen) };
    return h(
      "div",
      { class: "paired-chair row" },
      h("b", {}, t("screens-name", { number: screen.number })),
      h(
        "span",
        { class: `tag ${screen.connected ? "" : "att"}` },
        t(`screens-${screen.connected ? "connected" : "away"}`),
      ),
      screen.picture &&
        h("span", { class: `tag ${screen.picture === "none" ? "att" : ""}` }, t(`screens-picture-${screen.picture}`)),
      h("span", { class: "quiet small grow" }, t("screens-since", { when: moment(screen.paired) })),
      h("button", action, t("screens-unpair")),
    );
  };
  const offer = () => {
    isOpen = false;
    put(below, h("button", { type: "button", class: "btn", onclick: open }, icon("plus", 20), t("screens-pair")));
  };
  /** @returns {Promise<void>} */
  const open = () =>
    app.toasts.attempt(async () => {
      const made = await app.api.post("/patient-screen/pairing");
      isOpen = true;
      put(below, codeView(app, made, { onAgain: open, onClose: offer }, signal, isPage ? "h2" : "h3"));
      /** @type {HTMLElement | null} */ (below.querySelector(".paired > :first-child"))?.focus();
    });
  app.live.addEventListener("changed", ({ detail }) => concerns(detail, { what: ["screens", "session"] }) && read(), {
    signal,
  });
  let session = app.session?.session?.id;
  const showSession = () => {
    if (app.session?.session?.id === session) return;
    session = app.session?.session?.id;
    offer(); // a code is for one session
    read();
  };
  app.addEventListener("session", showSession, { signal });
  offer();
  await read(); // before it is shown, so that nothing on it moves
  return element;
}

/**
 * The code to scan, its link, and how long they hold.
 * @param {import("../main.js").App} app @param {OfferView} offer
 * @param {{onAgain: () => void, onClose: () => void}} actions @param {AbortSignal} signal
 * @param {"h2" | "h3"} heading
 */
function codeView(app, { code, url, qr, message, expires }, { onAgain, onClose }, signal, heading) {
  const about = h("p", { role: "status" });
  const link = h("code", {}, url);
  const copy = () => copyText(app, url, t("screens-copied"), t("screens-copy-failed"));
  /** @param {string} text @param {() => void} run */
  const button = (text, run) => h("button", { type: "button", class: "btn", onclick: run }, text);
  const picture = h("img", { class: "qr", src: pictureOf(qr), alt: t("screens-qr"), width: 240, height: 240 });
  const element = h(
    "div",
    { class: "paired" },
    h(heading, { tabindex: "-1" }, t("screens-pair")),
    about,
    message && h("p", { class: "att" }, message),
    picture,
    h("p", {}, t("screens-type", { address: url.slice(0, url.indexOf("#")) })),
    h("p", { class: "typed-code" }, `${code.slice(0, 4)} ${code.slice(4)}`),
    h("p", { class: "small" }, t("screens-link")),
    h("pre", {}, link),
    h(
      "div",
      { class: "spread" },
      button(t("screens-copy"), copy),
      button(t("screens-again"), onAgain),
      button(t("screens-close"), onClose),
    ),
  );
  const show = () => {
    const left = Date.parse(expires) - Date.now();
    picture.hidden = left <= 0;
    const minutes = Math.max(1, Math.ceil(left / MINUTE));
    write(about, left > 0 ? t("screens-scan", { minutes }) : t("screens-expired"));
  };
  const timer = setInterval(() => (element.isConnected ? show() : clearInterval(timer)), LOOK_EVERY);
  signal.addEventListener("abort", () => clearInterval(timer));
  show();
  return element;
}
