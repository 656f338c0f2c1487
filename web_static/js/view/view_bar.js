/** The choice of the view, in 3D or the drawn plan; the settings of the patient's eye; the pad of the free camera. */
import { newestWins } from "../live/newest_wins.js";
import { Fragment, h, render, signal } from "../preact.js";
import { t } from "../texts.js";
import { Segments } from "../widgets/fields.js";
import { freeCamera } from "./free_camera.js";
import { chosenEye, shownEye, storeEye, ViewSettings } from "./view_settings.js";
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
  const view = signal(chosenView());
  const eye = signal(chosenEye());
  const free = freeCamera((place) => app.toasts.attempt(() => app.api.post("/view/clinician/free", place)), surface);
  const send = newestWins(async (/** @type {import("types/api").CameraChoice} */ choice) => {
    const answer = await app.toasts.attempt(() => app.api.post("/view/clinician/camera", choice));
    if (answer && choice.view === view.value) free.open(view.value === "free", answer.free);
  }, SEND_EVERY);
  // The eye is the patient's: its settings also apply to the patient's own screen, which has no settings.
  const sendPatients = newestWins(
    (/** @type {import("./view_settings.js").Eye} */ chosen) =>
      app.toasts.attempt(() => app.api.post("/view/patient/camera", chosen)),
    SEND_EVERY,
  );
  const look = () => {
    const { value: name } = view;
    if (name !== "plan") send({ view: name, ...shownEye(eye.value) });
  };
  /** @param {string} name */
  const choose = (name) => {
    const chosen = viewNamed(name);
    if (!chosen || chosen === view.value) return;
    view.value = chosen;
    chooseView(chosen);
    free.open(false);
    onChoose(chosen === "plan" ? "plan" : "view");
    look();
  };
  /** @param {Partial<import("./view_settings.js").Eye>} change */
  const changeEye = (change) => {
    eye.value = { ...eye.value, ...change };
    storeEye(eye.value);
    look();
    sendPatients(eye.value);
  };
  look();
  sendPatients(eye.value);
  const disabled = canDrawIn3d() ? [] : VIEWS_IN_3D.filter((name) => name !== view.value);
  const options = VIEWS.map((value) => ({ value, label: t(`trial-view-${value}`) }));
  const Bar = () =>
    h(
      Fragment,
      {},
      h(Segments, { label: t("trial-views"), options, chosen: view.value, disabled, onChange: choose }),
      h(ViewSettings, { eye: eye.value, onChange: changeEye }),
    );
  const element = document.createElement("div");
  element.className = "view-bar";
  render(h(Bar, {}), element);
  return { element, pad: free.element, choosePlan: () => choose("plan") };
}
