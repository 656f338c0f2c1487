/** The settings of the patient's eye: field of view, eye height, comfort, head; stored in this browser. */
import { Fragment, h, useState } from "../preact.js";
import { limitsOf, REFERENCE } from "../reference.js";
import { t } from "../texts.js";
import { Toggle } from "../widgets/fields.js";
import { Icon } from "../widgets/icons.js";
import { Setting, Stepper } from "../widgets/setting.js";

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

/** The eye that was chosen in this browser. @returns {Eye} */
export const chosenEye = () => ({ ...usualEye(), ...storedEye() });

/** @param {Eye} eye */
export const storeEye = (eye) => localStorage.setItem(STORAGE_KEY, JSON.stringify(eye));

/** The eye as this screen shows it. @param {Eye} eye @returns {Eye} */
export const shownEye = (eye) => (REDUCED.matches ? { ...eye, roll_share: 0 } : eye);

/** The least and the greatest value of a number. @param {NumberName} name @returns {[number, number]} */
function rangeOf(name) {
  const { minimum, maximum } = limitsOf("CameraChoice", name);
  return [minimum ?? -Infinity, maximum ?? Infinity];
}

let made = 0; // panels, each with an id of its own

/** The button, and the panel that it opens. @param {{eye: Eye, onChange: (change: Partial<Eye>) => void}} settings */
export function ViewSettings({ eye, onChange }) {
  const [id] = useState(() => `view-settings-${++made}`);
  /**
   * @param {NumberName} name @param {number} size of a step @param {number} digits @param {string} unit
   * @param {number} [scale] of the number on screen
   */
  const step = (name, size, digits, unit, scale = 1) =>
    h(Stepper, {
      label: t(`trial-view-${name}`),
      value: eye[name] * scale,
      low: rangeOf(name)[0] * scale,
      high: rangeOf(name)[1] * scale,
      step: size,
      digits,
      unit,
      onChange: (value) => onChange({ [name]: value / scale }),
    });
  const words = t("trial-view-settings");
  return h(
    Fragment,
    {},
    h(
      "button",
      { type: "button", class: "btn small", popovertarget: id, "aria-label": words, title: words },
      h(Icon, { name: "settings" }),
    ),
    h(
      "div",
      { class: "card view-settings", id, popover: "auto", role: "group", "aria-label": words },
      h(Setting, { title: t("trial-view-fov-deg") }, step("fov_deg", 2, 0, "°")),
      h(Setting, { title: t("trial-view-eye-height") }, step("eye_height", 0.05, 2, "m")),
      h(
        Setting,
        {
          title: t("trial-view-roll-share"),
          hint: t(REDUCED.matches ? "trial-view-reduced" : "trial-view-roll-share-why"),
        },
        REDUCED.matches ? h("span", {}) : step("roll_share", 25, 0, "%", 100),
      ),
      h(
        Setting,
        { title: t("trial-view-head"), hint: t("trial-view-head-why") },
        h(Toggle, { label: t("trial-view-head-on"), on: eye.head, onChange: (head) => onChange({ head }) }),
      ),
      h(
        Setting,
        { title: t("stereo-open"), hint: t("stereo-open-why") },
        h("a", { class: "btn small", href: "stereo.html", target: "_blank" }, t("stereo-open-link")),
      ),
    ),
  );
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
