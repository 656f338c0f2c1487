/** How the patient's eye looks: field of view, eye height, comfort, head; remembered on this screen. */
import { t } from "../texts.js";
import { h } from "../widgets/dom.js";
import { setting, stepper, toggle } from "../widgets/fields.js";
import { icon } from "../widgets/icons.js";

const PLACE = "bodydrive-eye";
const USUAL = { fov_deg: 68, eye_height: 1.2, roll_share: 0, head: true };
const RANGES = { fov_deg: [30, 110], eye_height: [0.8, 1.6], roll_share: [0, 1], head: [false, true] };
const REDUCED = matchMedia("(prefers-reduced-motion: reduce)");

let made = 0;

/**
 * @param {() => void} onChange
 * @returns {{button: HTMLElement, panel: HTMLElement, eye: typeof USUAL, mine: () => typeof USUAL}}
 *   what was chosen, and what of it this screen shows
 */
export function viewSettings(onChange) {
  const eye = { ...USUAL, ...remembered() };
  const set = (name) => (value) => {
    eye[name] = value;
    localStorage.setItem(PLACE, JSON.stringify(eye));
    onChange();
  };
  const step = (name, low, high, size, digits, unit, toShown = 1) =>
    stepper({
      label: t(`trial.view.${name}`),
      value: eye[name] * toShown,
      low,
      high,
      step: size,
      digits,
      unit,
      onChange: (value) => set(name)(value / toShown),
    });
  const id = `view-settings-${++made}`;
  const panel = h(
    "div",
    { class: "card view-settings", id, popover: "auto", role: "group", "aria-label": t("trial.view.settings") },
    setting(t("trial.view.fov_deg"), "", step("fov_deg", ...RANGES.fov_deg, 2, 0, "°")),
    setting(t("trial.view.eye_height"), "", step("eye_height", ...RANGES.eye_height, 0.05, 2, "m")),
    setting(
      t("trial.view.roll_share"),
      REDUCED.matches ? t("trial.view.reduced") : t("trial.view.roll_share.why"),
      REDUCED.matches ? h("span", {}) : step("roll_share", 0, 100, 25, 0, "%", 100),
    ),
    setting(t("trial.view.head"), t("trial.view.head.why"), toggle(t("trial.view.head.on"), eye.head, set("head"))),
    setting(
      t("stereo.open"),
      t("stereo.open.why"),
      h("a", { class: "btn small", href: "stereo.html", target: "_blank" }, t("stereo.open.link")),
    ),
  );
  const words = t("trial.view.settings");
  const button = h(
    "button",
    { type: "button", class: "btn small", popovertarget: id, "aria-label": words, title: words },
    icon("settings"),
  );
  return { button, panel, eye, mine: () => (REDUCED.matches ? { ...eye, roll_share: 0 } : eye) };
}

function remembered() {
  try {
    const found = JSON.parse(localStorage.getItem(PLACE) ?? "{}");
    return Object.fromEntries(Object.keys(USUAL).flatMap((name) => kept(name, found?.[name])));
  } catch {
    return {};
  }
}

function kept(name, value) {
  const [low, high] = RANGES[name];
  return typeof value === typeof low && value >= low && value <= high ? [[name, value]] : [];
}
