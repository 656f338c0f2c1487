/** The controls of the stereo page: there when somebody moves, taps or types, gone when they only look. */
import { h } from "../widgets/dom.js";
import { segments, selection, setting, stepper, toggle } from "../widgets/fields.js";
import { t } from "../texts.js";
import { CONVERGENCES, MODES, MOST_APART } from "./settings.js";

const SHOWN = 8000; // ms

/**
 * @param {import("./settings.js").Settings} settings @param {HTMLElement} root what is looked at
 * @param {AbortSignal} signal
 */
export function controlBar(settings, root, signal) {
  const { chosen } = settings;
  const modes = segments(
    t("stereo.mode"),
    MODES.map((value) => ({ value, label: t(`stereo.mode.${value}`) })),
    chosen.mode,
    (mode) => settings.choose({ mode }),
  );
  const modeSetting = setting(t("stereo.mode"), t(`stereo.mode.${chosen.mode}.why`), modes);
  const apart = stepper({
    label: t("stereo.apart"),
    value: chosen.apart,
    low: 0,
    high: MOST_APART,
    step: 1,
    digits: 0,
    unit: "mm",
    onChange: (value) => settings.choose({ apart: value }),
  });
  const convergence = selection(
    CONVERGENCES.map((value) => ({ value, label: value === "Infinity" ? t("stereo.far") : `${value} m` })),
    chosen.convergence,
    (value) => settings.choose({ convergence: value }),
  );
  convergence.setAttribute("aria-label", t("stereo.convergence"));
  const swap = toggle(t("stereo.swap"), chosen.swapped, (swapped) => settings.choose({ swapped }));
  const split = toggle(t("stereo.split"), chosen.split, (is) => settings.choose({ split: is }));
  const splitSetting = setting(t("stereo.split.title"), t("stereo.split.why"), split);
  const show = () => {
    const { mode, convergence: value } = settings.chosen;
    convergence.value = value; // another mode may have changed it
    modeSetting.querySelector("span").textContent = t(`stereo.mode.${mode}.why`);
    splitSetting.hidden = mode === "red-cyan";
  };
  settings.addEventListener("change", show, { signal });
  show();
  const bar = h(
    "section",
    { class: "hud stereo-bar", "aria-label": t("stereo.settings") },
    modeSetting,
    setting(t("stereo.apart"), t("stereo.apart.why"), apart),
    setting(t("stereo.convergence"), t("stereo.convergence.why"), convergence),
    setting(t("stereo.swap.title"), t("stereo.swap.why"), swap),
    splitSetting,
    document.fullscreenEnabled && setting(t("stereo.full"), t("stereo.full.why"), fullScreenButton(signal)),
    h("p", { class: "comfort" }, t("stereo.comfort")),
  );
  hideWhenQuiet(root, signal);
  return bar;
}

function fullScreenButton(signal) {
  const words = () => t(document.fullscreenElement ? "stereo.full.leave" : "stereo.full.enter");
  const button = h("button", { type: "button", class: "btn" }, words());
  button.addEventListener("click", () => {
    const asked = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen();
    asked.catch(() => null); // the browser has said why
  });
  document.addEventListener("fullscreenchange", () => (button.textContent = words()), { signal });
  return button;
}

/** @param {HTMLElement} root @param {AbortSignal} signal */
function hideWhenQuiet(root, signal) {
  let timer = 0;
  const wake = () => {
    root.classList.remove("is-quiet");
    clearTimeout(timer);
    timer = setTimeout(() => root.classList.add("is-quiet"), SHOWN);
  };
  for (const event of ["pointermove", "pointerdown", "keydown", "focusin", "change"])
    document.addEventListener(event, wake, { signal });
  signal.addEventListener("abort", () => clearTimeout(timer));
  wake();
}
