/** The strip under the header: connection lost, control process lost, a stop or fault that waits for Continue. */
import { t } from "../texts.js";
import { h, put } from "./dom.js";
import { icon } from "./icons.js";

/** @param {import("../main.js").App} app */
export function notices(app) {
  const element = h("div", { class: "notes", "aria-live": "assertive" });
  let shown = "";
  const show = () => {
    const kind = app.me?.signed_in ? wanted(app) : "";
    if (kind === shown) return;
    shown = kind;
    put(element, kind && note(app, kind));
  };
  app.live.addEventListener("tick", show);
  app.live.addEventListener("connection", show);
  for (const event of ["route", "me", "trial-view"]) app.addEventListener(event, show);
  return element;
}

/** The one thing that most needs to be known; empty when all is well. */
function wanted(app) {
  if (!app.live.connected) return "lost";
  const now = app.live.latest;
  if (!now) return "";
  if (now.control !== "alive") return "control";
  // While driving, the drive page shows faults over the picture itself.
  return now.fault && !app.showsTrial ? `fault ${now.fault.name}` : "";
}

function note(app, kind) {
  if (kind === "lost") return strip("bad", t("note.lost"), t("note.lost.why"));
  if (kind === "control") return strip("bad", t("note.control"), t("note.control.why"));
  const { happened, next_step: next } = app.live.latest.fault;
  return strip("", happened, next, continueButton(app));
}

/** @param {import("../main.js").App} app */
export function continueButton(app) {
  const button = h("button", { type: "button", class: "btn go" }, t("note.fault.continue"));
  button.addEventListener("click", async () => {
    button.disabled = true;
    try {
      await app.api.post("/control/clear");
    } catch (error) {
      app.toasts.show(error.message);
    }
    button.disabled = false;
  });
  return button;
}

function strip(tone, happened, why, button = null) {
  return h(
    "div",
    { class: `note ${tone}` },
    icon("warning"),
    h("div", { class: "grow" }, h("b", {}, happened), " ", why),
    button,
  );
}
