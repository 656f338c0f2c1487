/**
 * The patient's screens of this session: pair one by a code, what they show, unpair one.
 * @import { App } from "../main.js"
 * @import { OfferView, ScreensView, ScreenView, ScreenSettings } from "types/api"
 * @typedef {Awaited<ReturnType<typeof screenStore>>} ScreenStore
 */
import { giveFocus, passFocus } from "../focus.js";
import { onNews } from "../live/news.js";
import { Fragment, h, signal, useLayoutEffect, useOpening, useRef, useSignal } from "../preact.js";
import { t } from "../texts.js";
import { copyText } from "./clipboard.js";
import { Field, Selection, Toggle } from "./fields.js";
import { moment } from "./format.js";
import { Icon } from "./icons.js";
import { languageOptions, languagesOf } from "./language_choice.js";
import { useUntilGone } from "./made.js";
import { pictureOf } from "./one_time_key.js";

const WISHES = /** @type {const} */ (["arrow", "sounds", "large", "plan"]);
const LOOK_EVERY = 5000; // ms between two looks at the time that a code has left
const MINUTE = 60_000; // ms

/**
 * What the card shows, read before it is shown, so that nothing on it moves.
 * @param {App} app @param {AbortSignal} left
 */
export async function screenStore(app, left) {
  const isHere = signal(false); // whether somebody has a session
  const shown = signal(/** @type {ScreensView | null} */ (null)); // null: nobody is here, or it could not be read
  const code = signal(/** @type {OfferView | null} */ (null)); // the code that is shown
  const refusals = signal(0); // of choices
  const closeCode = () => void (code.value = null);
  /** @param {ScreensView} now */
  const show = (now) => {
    const before = shown.value?.screens;
    if (code.value && before && now.screens.some(({ id }) => !before.some((screen) => screen.id === id))) {
      app.toasts.show(t("screens-paired"));
      closeCode();
    }
    shown.value = now;
  };
  /** Show what a call answers. @param {Promise<ScreensView>} answer @returns {Promise<boolean | undefined>} whether it was done */
  const call = (answer) =>
    app.toasts.attempt(async () => {
      show(await answer);
      return true;
    });
  const read = async () => {
    isHere.value = Boolean(app.session?.patient);
    if (isHere.value) await call(app.api.get("/patient-screen"));
    else shown.value = null;
  };
  /** @type {Promise<unknown>} */
  let sent = Promise.resolve();
  /** Send one choice after the other: each adds to what the answer before it says. @param {Partial<ScreenSettings>} change */
  const choose = (change) => {
    const session = app.session?.session?.id;
    sent = sent.then(async () => {
      if (!shown.value || app.session?.session?.id !== session) return; // meant for somebody who is not here any more
      const settings = { ...shown.value.settings, ...change };
      if (await call(app.api.post("/patient-screen/settings", settings))) return;
      await read();
      refusals.value++;
    });
  };
  /** @param {ScreenView} screen */
  const unpair = async ({ id, number }) => {
    if (await call(app.api.remove(`/patient-screen/${id}`))) app.toasts.show(t("screens-unpaired", { number }));
  };
  const openCode = () =>
    app.toasts.attempt(async () => {
      code.value = await app.api.post("/patient-screen/pairing");
    });
  onNews(app, left, { what: ["screens", "session"] }, read);
  let session = app.session?.session?.id;
  const showSession = () => {
    if (app.session?.session?.id === session) return;
    session = app.session?.session?.id;
    closeCode(); // it is for one session
    read();
  };
  app.addEventListener("session", showSession, { signal: left });
  await read();
  return { app, left, isHere, shown, code, refusals, choose, unpair, openCode, closeCode };
}

/** @param {{store: ScreenStore, isPage?: boolean}} card isPage: on a page of its own, which has the heading */
export function PatientScreenCard({ store, isPage = false }) {
  const { shown, refusals, unpair } = store;
  const { screens = [], settings } = shown.value ?? {};
  const wishes = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    if (refusals.value) giveFocus(wishes.current?.querySelector("input"));
  }, [refusals.value]);
  return h(
    "section",
    { class: "card patient-screens" },
    !isPage && h("h2", {}, t("screens-title")),
    !isPage && h("p", { class: "quiet small" }, t("screens-lead")),
    h(
      "div",
      { class: "paired-chairs", role: screens.length ? "list" : undefined },
      screens.map((screen) => h(Row, { key: screen.id, screen, onUnpair: () => unpair(screen) })),
    ),
    // After a refusal, the choices are drawn anew, as they were.
    h("div", { class: "spread", ref: wishes }, settings && h(Wishes, { key: refusals.value, store, settings })),
    h(Pairing, { store, heading: isPage ? "h2" : "h3" }),
  );
}

/** @param {{screen: ScreenView, onUnpair: () => void}} row */
function Row({ screen: { number, connected, picture, paired }, onUnpair }) {
  return h(
    "div",
    { class: "paired-chair row", role: "listitem" },
    h("b", {}, t("screens-name", { number })),
    h("span", { class: `tag ${connected ? "" : "att"}` }, t(`screens-${connected ? "connected" : "away"}`)),
    picture && h("span", { class: `tag ${picture === "none" ? "att" : ""}` }, t(`screens-picture-${picture}`)),
    h("span", { class: "quiet small grow" }, t("screens-since", { when: moment(paired) })),
    h(
      "button",
      {
        type: "button",
        class: "btn",
        "aria-label": t("screens-unpair-label", { number }),
        ref: passFocus,
        onClick: onUnpair,
      },
      t("screens-unpair"),
    ),
  );
}

/** What the screens show, and in which language. @param {{store: ScreenStore, settings: ScreenSettings}} wishes */
function Wishes({ store: { app, choose }, settings }) {
  const languages = languagesOf(app);
  const language = h(Selection, {
    options: [{ value: "", label: t("language-of-browser") }, ...languageOptions(languages)],
    chosen: settings.language ?? "",
    onChange: (chosen) => choose({ language: chosen || null }),
  });
  return h(
    Fragment,
    {},
    WISHES.map((wish) =>
      h(Toggle, {
        key: wish,
        label: t(`screens-${wish}`),
        on: settings[wish],
        onChange: (on) => choose({ [wish]: on }),
      }),
    ),
    languages.length > 0 && h(Field, { label: t("language-screen") }, language),
  );
}

/** A button for a code, or the code. @param {{store: ScreenStore, heading: "h2" | "h3"}} pairing */
function Pairing({ store, heading }) {
  const { isHere, code, openCode } = store;
  const offer = isHere.value ? code.value : null;
  const place = useOpening(offer, ".paired > :first-child");
  const button = () =>
    h(
      "button",
      { type: "button", class: "btn", onClick: openCode },
      h(Icon, { name: "plus", size: 20 }),
      t("screens-pair"),
    );
  return h(
    "div",
    { ref: place },
    !isHere.value && h("p", { class: "quiet" }, t("screens-nobody")),
    isHere.value && !offer && button(),
    offer && h(CodeView, { key: offer.code, store, offer, heading }),
  );
}

/**
 * The code to scan, its link, and how long they hold.
 * @param {{store: ScreenStore, offer: OfferView, heading: "h2" | "h3"}} view
 */
function CodeView({ store: { app, left, openCode, closeCode }, offer: { code, url, qr, message, expires }, heading }) {
  const timeLeft = () => Date.parse(expires) - Date.now();
  const rest = useSignal(timeLeft());
  useUntilGone(left, (gone) => {
    const timer = setInterval(() => (rest.value = timeLeft()), LOOK_EVERY);
    gone.addEventListener("abort", () => clearInterval(timer));
  });
  const isOver = rest.value <= 0;
  const minutes = Math.max(1, Math.ceil(rest.value / MINUTE));
  const copy = () => copyText(app, url, t("screens-copied"), t("screens-copy-failed"));
  /** @param {string} text @param {() => void} onClick */
  const button = (text, onClick) => h("button", { type: "button", class: "btn", onClick }, text);
  return h(
    "div",
    { class: "paired" },
    h(heading, { tabindex: -1 }, t("screens-pair")),
    h("p", { role: "status" }, isOver ? t("screens-expired") : t("screens-scan", { minutes })),
    message && h("p", { class: "att" }, message),
    h("img", { class: "qr", src: pictureOf(qr), alt: t("screens-qr"), width: 240, height: 240, hidden: isOver }),
    h("p", {}, t("screens-type", { address: url.slice(0, url.indexOf("#")) })),
    h("p", { class: "typed-code" }, `${code.slice(0, 4)} ${code.slice(4)}`),
    h("p", { class: "small" }, t("screens-link")),
    h("pre", {}, h("code", {}, url)),
    h(
      "div",
      { class: "spread" },
      button(t("screens-copy"), copy),
      button(t("screens-again"), openCode),
      button(t("screens-close"), closeCode),
    ),
  );
}
