/** Where one looks from, or the drawn plan: the buttons, the eye's settings, and the free camera's pad. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { segments } from "../widgets/fields.js";
import { freeCamera } from "./free_camera.js";
import { newestWins } from "../live/newest_wins.js";
import { viewSettings } from "./view_settings.js";
import { canDrawIn3d } from "./webgl.js";

const VIEWS_IN_3D = ["eye", "chase", "top", "free"];
const VIEWS = [...VIEWS_IN_3D, "plan"];
const VIEW_PLACE = "bodydrive-view";
const SEND_EVERY = 50; // ms

/** The view that was chosen last on this page. @returns {string} */
export function chosenView() {
  const stored = sessionStorage.getItem(VIEW_PLACE) ?? "";
  return VIEWS.includes(stored) ? stored : "eye";
}

/** Choose the view that the next trial on this page begins with. @param {string} view */
export function chooseView(view) {
  sessionStorage.setItem(VIEW_PLACE, view);
}

/**
 * @param {import("../main.js").App} app @param {HTMLElement} surface what lies over the picture
 * @param {(which: "view" | "plan") => void} onChoose the 3D view or the drawn plan was chosen
 * @returns {{element: HTMLElement, pad: HTMLElement, choosePlan: () => void}} the bar, and what turns the free camera
 */
export function viewBar(app, surface, onChoose) {
  let view = chosenView();
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
  const look = () => view !== "plan" && send({ view, ...settings.mine() });
  // The eye is the patient's: the same settings hold on the patient's own screen, which can change nothing.
  const sendPatients = newestWins((eye) => ask(app.api.post("/view/patient/camera", eye)), SEND_EVERY);
  const choose = (chosen) => {
    view = chosen;
    chooseView(view);
    free.open(false);
    onChoose(view === "plan" ? "plan" : "view");
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
  const radio = (value) => views.querySelector(`input[value="${value}"]`);
  if (!canDrawIn3d()) for (const value of VIEWS_IN_3D) radio(value).disabled = value !== view;
  const element = h("div", { class: "view-bar" }, views, settings.button, settings.panel);
  return { element, pad: free.element, choosePlan: () => radio("plan").click() };
}
