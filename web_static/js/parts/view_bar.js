/** Where the 3D view is looked at from: the buttons, the eye's settings, and the free camera's pad. */
import { t } from "../texts.js";
import { h } from "./dom.js";
import { segments } from "./fields.js";
import { freeCamera } from "./free_camera.js";
import { newestWins } from "./newest_wins.js";
import { viewSettings } from "./view_settings.js";

const VIEWS = ["eye", "chase", "top", "free"];
const VIEW_PLACE = "bodydrive-view";
const SEND_EVERY = 50; // ms

/**
 * @param {import("../main.js").App} app @param {HTMLElement} surface what lies over the picture
 * @returns {{element: HTMLElement, pad: HTMLElement}} the bar, and what turns the free camera
 */
export function viewBar(app, surface) {
  const stored = sessionStorage.getItem(VIEW_PLACE) ?? "";
  let view = VIEWS.includes(stored) ? stored : "eye";
  const ask = (call) => call.catch((error) => app.toasts.show(error.message));
  const free = freeCamera((place) => ask(app.api.post("/view/clinician/free", place)), surface);
  const settings = viewSettings(() => {
    look();
    sendPatients({ ...settings.eye });
  });
  const send = newestWins(async (choice) => {
    const shown = await ask(app.api.post("/view/clinician/camera", choice));
    if (shown && choice.view === view) free.open(view === "free", shown.free);
  }, SEND_EVERY);
  const look = () => send({ view, ...settings.mine() });
  // The eye is the patient's: the same settings hold on the patient's own screen, which can change nothing.
  const sendPatients = newestWins((eye) => ask(app.api.post("/view/patient/camera", eye)), SEND_EVERY);
  const choose = (chosen) => {
    view = chosen;
    sessionStorage.setItem(VIEW_PLACE, view);
    free.open(false);
    look();
  };
  look();
  sendPatients({ ...settings.eye });
  const views = segments(
    t("trial.views"),
    VIEWS.map((value) => ({ value, label: t(`trial.view.${value}`) })),
    view,
    choose,
  );
  const element = h("div", { class: "view-bar" }, views, settings.button, settings.panel);
  return { element, pad: free.element };
}
