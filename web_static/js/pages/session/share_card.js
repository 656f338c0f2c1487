/**
 * The share links of a patient, with their ends and openings, and the form that makes one. Link and PIN are shown once.
 * @import { MadeShare, SessionRow, ShareRow, SharesView } from "types/api"
 * @import { Signal } from "../../preact.js"
 */
import { focusFirst, h, useRef, useSignal } from "../../preact.js";
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { copyText } from "../../widgets/clipboard.js";
import { Field, Selection } from "../../widgets/fields.js";
import { day, moment } from "../../widgets/format.js";

const ALL = "";
const DAYS = [1, 3, 7]; // below the longest that the server allows
const FIRST_DAYS = 7;

/**
 * @typedef {object} Shared what is shared
 * @property {import("../../main.js").App} app @property {Signal<SharesView>} shares
 * @property {number} patient id @property {string} code @property {SessionRow[]} sessions
 */

/** For how many days a link can be opened at most. */
const mostDays = () => limitsOf("NewShare", "days").maximum ?? Infinity;

/** @param {Shared & {isConsented: boolean}} card */
export function ShareCard({ isConsented, ...shared }) {
  const { app, shares, sessions } = shared;
  const heading = useRef(/** @type {HTMLHeadingElement | null} */ (null));
  const links = shares.value.shares;
  const open = links.filter(({ state }) => state === "open");
  const ended = links.filter(({ state }) => state !== "open");
  /** @param {number} id */
  const revoke = (id) =>
    app.toasts.attempt(async () => {
      shares.value = await app.api.remove(`/shares/${id}`);
      heading.current?.focus();
      app.toasts.show(t("shares-revoked"));
    });
  /** @param {ShareRow} link */
  const row = (link) => {
    const what = whatWords(sessions, link.session_id);
    return h(LinkRow, { key: link.id, link, what, isConsented, onRevoke: () => revoke(link.id) });
  };
  return h(
    "section",
    { class: "card stack" },
    h("h2", { tabindex: -1, ref: heading }, t("shares-title")),
    h("p", { class: "quiet small" }, t("shares-lead", { days: mostDays() })),
    h(
      "div",
      { class: "stack share-links" },
      open.length ? open.map(row) : h("p", { class: "quiet" }, t("shares-none")),
      ended.length > 0 &&
        h("details", {}, h("summary", {}, t("shares-ended", { count: ended.length })), ended.map(row)),
    ),
    isConsented ? h(NewLink, shared) : h("p", {}, t("shares-consent")),
  );
}

/**
 * @param {{link: ShareRow, what: string, isConsented: boolean, onRevoke: () => void}} row
 *   what: the description of what the link shows
 */
function LinkRow({ link, what, isConsented, onRevoke }) {
  const { person, created, expires, state, openings, last_opened: last, wrong_pins: wrong } = link;
  const isOpen = state === "open";
  const facts = [
    isOpen && t("shares-until", { moment: moment(expires) }),
    openings ? t("shares-openings", { count: openings, moment: moment(last) }) : t("shares-openings-none"),
    wrong > 0 && t("shares-wrong", { count: wrong }),
    t("shares-made", { moment: isOpen ? moment(created) : day(created), person }),
  ];
  return h(
    "article",
    { class: "share-link" },
    h(
      "div",
      { class: "grow" },
      h("h3", {}, what, " ", stateTag(isOpen && !isConsented ? "closed" : state)),
      h("p", { class: "quiet small" }, facts.filter(Boolean).join(" · ")),
    ),
    isOpen &&
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("shares-revoke-label", { what, moment: moment(created) }),
          onClick: onRevoke,
        },
        t("shares-revoke"),
      ),
  );
}

/** @param {ShareRow["state"] | "closed"} state */
function stateTag(state) {
  const tone = { open: "", closed: " att", dead: " att", over: " plain", revoked: " plain" }[state];
  return h("span", { class: `tag${tone}` }, t(`shares-state-${state}`));
}

/** The form that makes a link and, in its place, the link that it has made. @param {Shared} shared */
function NewLink({ app, shares, patient, code, sessions }) {
  const shown = useSignal(/** @type {{link: MadeShare, what: string} | null} */ (null));
  const wasShown = useRef(false);
  /** @param {number | null} session id @param {number} days */
  const make = (session, days) =>
    app.toasts.attempt(async () => {
      const link =
        session === null
          ? await app.api.post(`/patients/${patient}/shares`, { days })
          : await app.api.post(`/sessions/${session}/shares`, { days });
      shares.value = { ...shares.value, shares: link.shares };
      shown.value = { link, what: whatWords(sessions, session) };
      wasShown.current = true;
    });
  if (!shown.value) return h(LinkForm, { sessions, isAgain: wasShown.current, make });
  const { link, what } = shown.value;
  const copy = () => copyText(app, link.url, t("screens-copied"), t("screens-copy-failed"));
  return h(
    "section",
    { class: "paired" },
    h("h3", { tabindex: -1, ref: focusFirst }, t("shares-new", { what })),
    h("p", {}, t("shares-new-lead", { code })),
    link.message && h("p", { class: "att" }, link.message),
    h("pre", {}, h("code", {}, link.url)),
    h("p", { class: "small" }, t("shares-pin")),
    h("p", { class: "typed-code" }, link.pin),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onClick: copy }, t("screens-copy")),
      h("button", { type: "button", class: "btn go", onClick: () => (shown.value = null) }, t("shares-done")),
    ),
  );
}

/**
 * @param {object} form
 * @param {SessionRow[]} form.sessions @param {boolean} form.isAgain whether it appears after a link, and has the focus
 * @param {(session: number | null, days: number) => Promise<unknown>} form.make
 */
function LinkForm({ sessions, isAgain, make }) {
  const session = useSignal(ALL);
  const days = useSignal(String(Math.min(FIRST_DAYS, mostDays())));
  const isSending = useRef(false); // a second tap would make a second link
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    if (isSending.current) return;
    isSending.current = true;
    await make(session.value === ALL ? null : Number(session.value), Number(days.value));
    isSending.current = false;
  };
  const options = sessions.map(({ id }) => ({ value: String(id), label: whatWords(sessions, id) }));
  const lengths = [...DAYS.filter((count) => count < mostDays()), mostDays()];
  return h(
    "form",
    { class: "stack", onSubmit: submit },
    h(
      "div",
      { class: "columns" },
      h(
        Field,
        { label: t("shares-what") },
        h(Selection, {
          options: [{ value: ALL, label: t("shares-all") }, ...options],
          chosen: session.value,
          onChange: (value) => (session.value = value),
        }),
      ),
      h(
        Field,
        { label: t("shares-for") },
        h(Selection, {
          options: lengths.map((count) => ({ value: String(count), label: t("shares-days", { count }) })),
          chosen: days.value,
          onChange: (value) => (days.value = value),
        }),
      ),
    ),
    h("div", {}, h("button", { class: "btn", ref: isAgain ? focusFirst : null }, t("shares-make"))),
  );
}

/** @param {SessionRow[]} sessions @param {number | null} session id; null: all sessions */
function whatWords(sessions, session) {
  if (session === null) return t("shares-all");
  return t("shares-session", { number: sessions.find(({ id }) => id === session)?.number });
}
