/** The choice of the view, in 3D or the drawn plan; the settings of the patient's eye; the pad of the free camera. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { segments } from "../widgets/fields.js";
import { freeCamera } from "./free_camera.js";
import { newestWins } from "../live/newest_wins.js";
import { viewSettings } from "./view_settings.js";
import { canDrawIn3d } from "./webgl.js";

const VIEWS_IN_3D = /** @type {const} */ (["eye", "chase", "top", "free"]);
const VIEWS = /** @type {const} */ ([...VIEWS_IN_3D, "plan"]);
const STORAGE_KEY = "bodydrive-view";
const SEND_EVERY = 50; // ms

/** @typedef {typeof VIEWS[number]} ViewName */

/** The view that was chosen last on this page. @returns {ViewName} */
export function chosenView() {
  return viewNamed(sessionStorage.getItem(STORAGE_KEY)) ?? "eye";
}

/** @param {string | null} name */
function viewNamed(name) {
  return VIEWS.find((view) => view === name);
}

/** Choose the view with which the next trial on this page begins. @param {ViewName} view */
export function chooseView(view) {
  sessionStorage.setItem(STORAGE_KEY, view);
}

/**
 * @param {import("../main.js").App} app @param {HTMLElement} surface what lies over the picture
 * @param {(which: "view" | "plan") => void} onChoose the 3D view or the drawn plan was chosen
 * @returns {{element: HTMLElement, pad: HTMLElement, choosePlan: () => void}} the bar, and the buttons that turn the free camera
 */
export function viewBar(app, surface, onChoose) {
  let view = chosenView();
  const free = freeCamera((place) => app.toasts.attempt(() => app.api.post("/view/clinician/free", place)), surface);
  const settings = viewSettings(() => {
    look();
    sendPatients({ ...settings.eye });
  });
  const send = newestWins(async (/** @type {import("types/api").CameraChoice} */ choice) => {
    const answer = await app.toasts.attempt(() => app.api.post("/view/clinician/camera", choice));
    if (answer && choice.view === view) free.open(view === "free", answer.free);
  }, SEND_EVERY);
  const look = () => view !== "plan" && send({ view, ...settings.mine() });
  // The eye is the patient's: its settings also apply to the patient's own screen, which has no settings.
  const sendPatients = newestWins(
    (/** @type {import("./view_settings.js").Eye} */ eye) =>
      app.toasts.attempt(() => app.api.post("/view/patient/camera", eye)),
    SEND_EVERY,
  );
  /** @param {string} name */
  const choose = (name) => {
    view = viewNamed(name) ?? view;
    chooseView(view);
    free.open(false);
    onChoose(view === "plan" ? "plan" : "view");
    look();
  };
  look();
  sendPatients({ ...settings.eye });
  const views = segments(
    t("trial-views"),
    VIEWS.map((value) => ({ value, label: t(`trial-view-${value}`) })),
    view,
    choose,
  );
  /** @param {ViewName} name @returns {HTMLInputElement} */
  const radio = (name) => /** @type {HTMLInputElement} */ (views.querySelector(`input[value="${name}"]`));
  if (!canDrawIn3d()) for (const name of VIEWS_IN_3D) radio(name).disabled = name !== view;
  const element = h("div", { class: "view-bar" }, views, settings.button, settings.panel);
  return { element, pad: free.element, choosePlan: () => radio("plan").click() };
}
