/**
 * The share links of a patient, with their ends and openings, and the form that makes one. Link and PIN are shown once.
 * @import { ConsentsView, MadeShare, SessionRow, ShareRow, SharesView } from "types/api"
 */
import { limitsOf } from "../../reference.js";
import { t } from "../../texts.js";
import { copyText } from "../../widgets/clipboard.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { day, moment } from "../../widgets/format.js";

const ALL = "";
const DAYS = [1, 3, 7]; // beside the longest that the server allows
const FIRST_DAYS = "7";

/**
 * @param {import("../../main.js").App} app @param {ConsentsView} consents @param {SessionRow[]} sessions
 * @param {SharesView} found @param {AbortSignal} signal
 * @returns {{element: HTMLElement, setConsents: (now: ConsentsView) => void}}
 */
export function shareCard(app, { patient_id: patient, code, consents }, sessions, { shares }, signal) {
  /** @param {ConsentsView["consents"]} all */
  const isGiven = (all) => all.some(({ consent, given }) => consent === "sharing" && given);
  let isConsented = isGiven(consents);
  const heading = h("h2", { tabindex: "-1" }, t("shares-title"));
  const list = h("div", { class: "stack share-links" });
  const place = h("div", {});
  /** @param {number | null} session id */
  const whatWords = (session) =>
    session === null
      ? t("shares-all")
      : t("shares-session", { number: sessions.find(({ id }) => id === session)?.number });
  /** @param {ShareRow} link */
  const revoke = (link) =>
    app.toasts.attempt(async () => {
      ({ shares } = await app.api.remove(`/shares/${link.id}`));
      draw();
      heading.focus();
      app.toasts.show(t("shares-revoked"));
    });
  /** @param {ShareRow} link */
  const row = (link) => {
    const {
      session_id: session,
      person,
      created,
      expires,
      state,
      openings,
      last_opened: last,
      wrong_pins: wrong,
    } = link;
    const what = whatWords(session);
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
        h("h3", {}, what, " ", tag(isOpen && !isConsented ? "closed" : state)),
        h("p", { class: "quiet small" }, facts.filter(Boolean).join(" · ")),
      ),
      isOpen &&
        h(
          "button",
          {
            type: "button",
            class: "btn small",
            "aria-label": t("shares-revoke-label", { what, moment: moment(created) }),
            onclick: () => revoke(link),
          },
          t("shares-revoke"),
        ),
    );
  };
  const draw = () => {
    const open = shares.filter(({ state }) => state === "open");
    const ended = shares.filter(({ state }) => state !== "open");
    const isUnfolded = list.querySelector("details")?.open ?? false;
    put(
      list,
      open.length ? open.map(row) : h("p", { class: "quiet" }, t("shares-none")),
      ended.length > 0 &&
        h(
          "details",
          { open: isUnfolded },
          h("summary", {}, t("shares-ended", { count: ended.length })),
          ended.map(row),
        ),
    );
  };
  const offer = () => put(place, isConsented ? form() : h("p", {}, t("shares-consent")));
  const form = () => {
    const options = sessions.map(({ id }) => ({ value: String(id), label: whatWords(id) }));
    const what = selection([{ value: ALL, label: t("shares-all") }, ...options], ALL);
    const longest = limitsOf("NewShare", "days").maximum ?? Infinity;
    const days = selection(
      [...DAYS, longest].map((count) => ({ value: String(count), label: t("shares-days", { count }) })),
      FIRST_DAYS,
    );
    let isBusy = false;
    /** @param {SubmitEvent} event */
    const make = async (event) => {
      event.preventDefault();
      if (isBusy) return;
      isBusy = true;
      const wish = { days: Number(days.value) };
      const session = what.value === ALL ? null : Number(what.value);
      const made = await app.toasts.attempt(() =>
        session === null
          ? app.api.post(`/patients/${patient}/shares`, wish)
          : app.api.post(`/sessions/${session}/shares`, wish),
      );
      isBusy = false;
      if (!made) return;
      ({ shares } = made);
      draw();
      put(
        place,
        newLink(app, made, whatWords(session), code, () => (offer(), place.querySelector("button")?.focus())),
      );
      place.querySelector("h3")?.focus();
    };
    return h(
      "form",
      { class: "stack", onsubmit: make },
      h("div", { class: "columns" }, field(t("shares-what"), what), field(t("shares-for"), days)),
      h("div", {}, h("button", { class: "btn" }, t("shares-make"))),
    );
  };
  /** @param {ConsentsView} now */
  const setConsents = (now) => {
    const before = isConsented;
    isConsented = isGiven(now.consents);
    if (isConsented === before) return;
    draw();
    offer();
  };
  /** Links are opened, made and revoked elsewhere, too. @param {CustomEvent<string>} event */
  const read = async ({ detail }) => {
    if (detail !== "shares" && detail !== "everything") return;
    const now = await app.api.get(`/patients/${patient}/shares`).catch(() => null);
    if (signal.aborted || !now) return;
    ({ shares } = now);
    draw();
  };
  app.live.addEventListener("changed", read, { signal });
  draw();
  offer();
  const element = h(
    "section",
    { class: "card stack" },
    heading,
    h("p", { class: "quiet small" }, t("shares-lead")),
    list,
    place,
  );
  return { element, setConsents };
}

/** @param {ShareRow["state"] | "closed"} state */
function tag(state) {
  const tone = { open: "", closed: " att", dead: " att", over: " plain", revoked: " plain" }[state];
  return h("span", { class: `tag${tone}` }, t(`shares-state-${state}`));
}

/**
 * @param {import("../../main.js").App} app @param {MadeShare} made @param {string} what it shows @param {string} code
 * @param {() => void} onDone
 */
function newLink(app, { url, pin, message }, what, code, onDone) {
  const copy = () => copyText(app, url, t("screens-copied"), t("screens-copy-failed"));
  return h(
    "section",
    { class: "paired" },
    h("h3", { tabindex: "-1" }, t("shares-new", { what })),
    h("p", {}, t("shares-new-lead", { code })),
    message && h("p", { class: "att" }, message),
    h("pre", {}, h("code", {}, url)),
    h("p", { class: "small" }, t("shares-pin")),
    h("p", { class: "typed-code" }, pin),
    h(
      "div",
      { class: "spread" },
      h("button", { type: "button", class: "btn", onclick: copy }, t("screens-copy")),
      h("button", { type: "button", class: "btn go", onclick: onDone }, t("shares-done")),
    ),
  );
}
