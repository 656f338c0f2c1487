/** The controls of the stereo page: visible after a movement, tap or key, hidden after 8 s without any. */
import { h, put } from "../widgets/dom.js";
import { segments, selection, setting, stepper, toggle } from "../widgets/fields.js";
import { unrounded } from "../widgets/format.js";
import { t } from "../texts.js";
import { CONVERGENCES, MODES, MOST_APART } from "./settings.js";

const VISIBLE_FOR = 8000; // ms

/**
 * @param {import("./settings.js").Settings} settings @param {HTMLElement} root of the page
 * @param {AbortSignal} signal
 */
export function controlBar(settings, root, signal) {
  const { chosen } = settings;
  const modes = segments(
    t("stereo-mode"),
    MODES.map((value) => ({ value, label: t(`stereo-mode-${value}`) })),
    chosen.mode,
    (name) => settings.choose({ mode: MODES.find((mode) => mode === name) }),
  );
  const modeSetting = setting(t("stereo-mode"), t(`stereo-mode-${chosen.mode}-why`), modes);
  const apart = stepper({
    label: t("stereo-apart"),
    value: chosen.apart,
    low: 0,
    high: MOST_APART,
    step: 1,
    digits: 0,
    unit: "mm",
    onChange: (value) => settings.choose({ apart: value }),
  });
  const convergence = selection(
    CONVERGENCES.map((value) => ({
      value,
      label: value === "Infinity" ? t("stereo-far") : `${unrounded(Number(value))} m`,
    })),
    chosen.convergence,
    (metres) => settings.choose({ convergence: CONVERGENCES.find((value) => value === metres) }),
  );
  convergence.setAttribute("aria-label", t("stereo-convergence"));
  const swap = toggle(t("stereo-swap"), chosen.swapped, (swapped) => settings.choose({ swapped }));
  const split = toggle(t("stereo-split"), chosen.split, (is) => settings.choose({ split: is }));
  const splitSetting = setting(t("stereo-split-title"), t("stereo-split-why"), split);
  const show = () => {
    const { mode, convergence: value } = settings.chosen;
    convergence.value = value; // another mode may have changed it
    put(/** @type {HTMLElement} */ (modeSetting.querySelector("span")), t(`stereo-mode-${mode}-why`));
    splitSetting.hidden = mode === "red-cyan";
  };
  settings.addEventListener("change", show, { signal });
  show();
  const bar = h(
    "section",
    { class: "hud stereo-bar", "aria-label": t("stereo-settings") },
    modeSetting,
    setting(t("stereo-apart"), t("stereo-apart-why"), apart),
    setting(t("stereo-convergence"), t("stereo-convergence-why"), convergence),
    setting(t("stereo-swap-title"), t("stereo-swap-why"), swap),
    splitSetting,
    document.fullscreenEnabled && setting(t("stereo-full"), t("stereo-full-why"), fullScreenButton(signal)),
    h("p", { class: "comfort" }, t("stereo-comfort")),
  );
  hideWhenQuiet(root, signal);
  return bar;
}

/** @param {AbortSignal} signal */
function fullScreenButton(signal) {
  const words = () => t(document.fullscreenElement ? "stereo-full-leave" : "stereo-full-enter");
  const button = h("button", { type: "button", class: "btn" }, words());
  button.addEventListener("click", () => {
    const root = document.documentElement;
    const change = document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen();
    change.catch(() => null); // the browser shows the reason
  });
  document.addEventListener("fullscreenchange", () => (button.textContent = words()), { signal });
  return button;
}

/** @param {HTMLElement} root @param {AbortSignal} signal */
function hideWhenQuiet(root, signal) {
  let timer = 0;
  const show = () => {
    root.classList.remove("is-quiet");
    clearTimeout(timer);
    timer = setTimeout(() => root.classList.add("is-quiet"), VISIBLE_FOR);
  };
  for (const event of ["pointermove", "pointerdown", "keydown", "focusin", "change"])
    document.addEventListener(event, show, { signal });
  signal.addEventListener("abort", () => clearTimeout(timer));
  show();
}
