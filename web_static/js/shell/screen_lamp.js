/** The lamp of the patient's screens in the header: there is one while a screen is paired. */
import { concerns } from "../live/news.js";
import { screenState } from "../pages/drive/screen_words.js";
import { t } from "../texts.js";
import { h, write } from "../widgets/dom.js";

const SETTLES = 300; // ms: the end of a session unpairs its screens before the live picture says that it has ended

/** @param {import("../main.js").App} app */
export function screenLamp(app) {
  const lamp = h("span", { class: "lamp screen-lamp", hidden: true });
  /** The id of the open session; without one nothing is paired. @type {number | null} */
  let session = null;
  const refresh = async () => {
    session = app.live.connected ? (app.live.latest?.session ?? null) : null;
    const mayAsk = session !== null && app.me?.signed_in && app.me.role !== "reviewer" && !app.lock.isLocked;
    const screens = mayAsk ? ((await app.api.get("/patient-screen").catch(() => null))?.screens ?? []) : [];
    const state = screenState(screens);
    lamp.hidden = state === "-none";
    const isBad = state !== "" && !lamp.hidden;
    lamp.className = `lamp screen-lamp${isBad ? " att long" : " wide"}`; // on a small screen only what is not right
    write(lamp, lamp.hidden ? "" : t(`lamp-screen${state}`, { count: screens.length }));
  };
  app.addEventListener("me", refresh);
  app.live.addEventListener("tick", ({ detail }) => (detail.session ?? null) !== session && refresh());
  app.live.addEventListener("changed", ({ detail }) => {
    if (concerns(detail, { what: ["screens"] })) setTimeout(refresh, SETTLES);
  });
  app.live.addEventListener("connection", refresh);
  return lamp;
}
