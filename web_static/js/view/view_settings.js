/** The settings of the patient's eye: field of view, eye height, comfort, head; stored in this browser. */
import { limitsOf, REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { setting, stepper, toggle } from "../widgets/fields.js";
import { icon } from "../widgets/icons.js";

const STORAGE_KEY = "bodydrive-eye";
/**
 * @typedef {"fov_deg" | "eye_height" | "roll_share"} NumberName
 * @typedef {Record<NumberName, number> & {head: boolean}} Eye fov_deg: °; eye_height: m; roll_share: of the chair's roll;
 *   head: whether the view follows the head
 */

/** What a screen shows on which nobody has chosen anything. @returns {Eye} */
const usualEye = () => ({
  fov_deg: REFERENCE.numbers.field_of_view,
  eye_height: REFERENCE.numbers.eye_height,
  roll_share: 0,
  head: true,
});
const REDUCED = matchMedia("(prefers-reduced-motion: reduce)");

/** The least and the greatest value of a number. @param {NumberName} name @returns {[number, number]} */
function rangeOf(name) {
  const { minimum, maximum } = limitsOf("CameraChoice", name);
  return [minimum ?? -Infinity, maximum ?? Infinity];
}

let made = 0; // panels, each with an id of its own

/**
 * @param {() => void} onChange
 * @returns {{button: HTMLElement, panel: HTMLElement, eye: Eye, mine: () => Eye}} eye: as chosen; mine: as this screen shows it
 */
export function viewSettings(onChange) {
  const eye = { ...usualEye(), ...storedEye() };
  /** @param {Partial<Eye>} change */
  const set = (change) => {
    Object.assign(eye, change);
    localStorage.setItem(STORAGE_KEY, JSON.stringify(eye));
    onChange();
  };
  /**
   * @param {NumberName} name @param {number} size of a step @param {number} digits @param {string} unit
   * @param {number} [scale] of the number on screen
   */
  const step = (name, size, digits, unit, scale = 1) =>
    stepper({
      label: t(`trial-view-${name}`),
      value: eye[name] * scale,
      low: rangeOf(name)[0] * scale,
      high: rangeOf(name)[1] * scale,
      step: size,
      digits,
      unit,
      onChange: (value) => set({ [name]: value / scale }),
    });
  const id = `view-settings-${++made}`;
  const panel = h(
    "div",
    { class: "card view-settings", id, popover: "auto", role: "group", "aria-label": t("trial-view-settings") },
    setting(t("trial-view-fov-deg"), "", step("fov_deg", 2, 0, "°")),
    setting(t("trial-view-eye-height"), "", step("eye_height", 0.05, 2, "m")),
    setting(
      t("trial-view-roll-share"),
      REDUCED.matches ? t("trial-view-reduced") : t("trial-view-roll-share-why"),
      REDUCED.matches ? h("span", {}) : step("roll_share", 25, 0, "%", 100),
    ),
    setting(
      t("trial-view-head"),
      t("trial-view-head-why"),
      toggle(t("trial-view-head-on"), eye.head, (head) => set({ head })),
    ),
    setting(
      t("stereo-open"),
      t("stereo-open-why"),
      h("a", { class: "btn small", href: "stereo.html", target: "_blank" }, t("stereo-open-link")),
    ),
  );
  const words = t("trial-view-settings");
  const button = h(
    "button",
    { type: "button", class: "btn small", popovertarget: id, "aria-label": words, title: words },
    icon("settings"),
  );
  return { button, panel, eye, mine: () => (REDUCED.matches ? { ...eye, roll_share: 0 } : eye) };
}

/** The stored settings that are valid. @returns {Partial<Eye>} */
function storedEye() {
  try {
    const stored = JSON.parse(localStorage.getItem(STORAGE_KEY) ?? "{}");
    return Object.fromEntries(Object.keys(usualEye()).flatMap((name) => validField(name, stored?.[name])));
  } catch {
    return {};
  }
}

/** @param {string} name @param {unknown} value @returns {[string, unknown][]} none when the value is not valid */
function validField(name, value) {
  if (name === "head") return typeof value === "boolean" ? [[name, value]] : [];
  const [low, high] = rangeOf(/** @type {NumberName} */ (name));
  return typeof value === "number" && value >= low && value <= high ? [[name, value]] : [];
}
