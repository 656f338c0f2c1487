/**
 * The strips under the header: connection lost, control process lost, a stop or fault that waits for Continue, a full
 * disk, backups that are not made; and for a person's first time the sentences on how to find one's way.
 * @import { Child } from "types/dom"
 * @import { App } from "../main.js"
 * @import { Halt } from "./halt.js"
 */
import { giveFocus } from "../focus.js";
import { t } from "../texts.js";
import { h, put, set } from "../widgets/dom.js";
import { timeOfDay } from "../widgets/format.js";
import { icon } from "../widgets/icons.js";
import { continueButton, mayGoOn } from "./continue_button.js";
import { urgency } from "./halt.js";
import { isPageOff } from "./offline.js";

/** @param {import("../main.js").App} app */
export function notices(app) {
  const element = h("div", { class: "notes", "aria-live": "polite" });
  let shown = "";
  const show = () => {
    const halt = app.halt(app.live.latest?.fault, app.live.latest?.stops ?? 0);
    const kind = app.me?.signed_in ? noticeKind(app, halt) : "";
    // A screen reader does not find a page that is off: then the notice is all there is to read, unless a cover is.
    const isAll = kind === "lost, page off" && ![...document.querySelectorAll("main")].some((one) => one !== app.root);
    set(element, { role: isAll ? "main" : null });
    if (kind === shown) return;
    shown = kind;
    set(element, { "aria-live": urgency(halt) });
    const hadFocus = element.contains(document.activeElement);
    put(element, kind && note(app, kind, halt));
    if (hadFocus) giveFocus(element.querySelector(".btn"));
  };
  app.live.addEventListener("tick", show);
  app.live.addEventListener("connection", show);
  for (const event of /** @type {const} */ (["route", "me", "session", "practice", "trial-view", "warning"]))
    app.addEventListener(event, show);
  return element;
}

/** The sentences for a first time, in full or folded, until the person puts them away; a trial has the page for itself. @param {App} app */
export function firstTimePlace(app) {
  const element = h("div", { class: "first-time-place" });
  const show = async () => {
    if (!app.me?.signed_in || app.me.introduced || app.me.locked) {
      app.frame.classList.remove("first-time");
      put(element);
    } else if (!element.hasChildNodes()) (await import("../help/first_time.js")).showFirstTime(app, element);
  };
  app.addEventListener("me", show);
  app.addEventListener("trial-view", () => (element.hidden = app.showsTrial));
  app.live.addEventListener("connection", () => (element.inert = !app.live.connected)); // putting them away is stored
  return element;
}

/** The kind of the one notice that is needed most; empty when all is well. @param {App} app @param {Halt | null} halt */
function noticeKind(app, halt) {
  if (!app.live.connected) return isPageOff(app) ? "lost, page off" : "lost";
  const now = app.live.latest;
  if (!now) return "";
  if (now.control !== "alive") return "control";
  // While driving, the drive page shows faults over the picture itself.
  if (halt && !app.showsTrial) return `${halt.key} ${placeOfDrive(now)}`;
  if (now.drive && !app.showsTrial) return "driving";
  if (app.warning && !app.showsTrial && app.warning.href !== `#/${app.route.page}`)
    return `warning ${app.warning.words}`;
  return needsConsent(app) ? `consent ${app.session?.patient?.id}` : "";
}

/** Whether the patient who is here has to be asked before a worn shirt may record. @param {App} app */
function needsConsent({ session, practice, showsTrial, route, me }) {
  const isOnItsPage = route.page === "session" && route.rest[0] === "patient";
  const mayEnter = me?.role === "owner" || me?.role === "clinician";
  return mayEnter && !!session?.patient && !session.consents_to_recording && !practice && !showsTrial && !isOnItsPage;
}

/** @param {App} app @param {string} kind @param {Halt | null} halt @returns {Child} */
function note(app, kind, halt) {
  if (kind.startsWith("lost")) {
    const words = t("note-lost", { time: timeOfDay(app.live.receivedAt) });
    return strip("bad", isPageOff(app) ? h("h1", {}, words) : h("b", {}, words), t("note-lost-why"));
  }
  if (kind === "control") return strip("bad", h("b", {}, t("note-control")), t("note-control-why"));
  if (kind === "driving")
    return strip(
      "",
      h("b", {}, t("note-driving")),
      "",
      h("a", { class: "btn go", href: "#/drive/chair" }, t("note-driving-go")),
    );
  if (kind.startsWith("warning") && app.warning) {
    const { words, href } = app.warning;
    return strip("", h("b", {}, words), "", href ? h("a", { class: "btn", href }, t("note-warning-go")) : null);
  }
  const patient = app.session?.patient;
  if (kind.startsWith("consent") && patient) {
    const enter = h("a", { class: "btn", href: `#/session/patient/${patient.id}` }, t("consent-needed-go"));
    return strip("", h("b", {}, t("consent-needed", { code: patient.code })), t("consent-needed-why"), enter);
  }
  if (!halt) return null;
  const happened = h("b", {}, halt.happened, halt.again && ` ${halt.again}`);
  const place = placeOfDrive(app.live.latest);
  if (!mayGoOn(app)) return strip("", happened, t(place ? "note-fault-others" : "note-fault-idle-others"));
  // Nobody lets a chair go on from a page that does not show it.
  if (place)
    return strip(
      "",
      happened,
      t("note-fault-drive"),
      h("a", { class: "btn go", href: place }, t("note-fault-drive-go")),
    );
  const back = continueButton(app, t("note-fault-idle-go"));
  return strip("", happened, `${halt.remedy} ${t("note-fault-idle")}`, back.element);
}

/** The address of the page that shows what is halted; empty when no trial and no drive runs. @param {App["live"]["latest"]} now */
function placeOfDrive(now) {
  if (now?.drive) return "#/drive/chair";
  return now?.trial ? "#/drive" : "";
}

/** @param {string} tone @param {HTMLElement} happened @param {string} why @param {Node | null} [button] */
function strip(tone, happened, why, button = null) {
  return h(
    "div",
    { class: `note ${tone}` },
    icon("warning"),
    h("div", { class: "grow" }, happened, why && ` ${why}`),
    button,
  );
}
