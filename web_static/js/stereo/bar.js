/** The controls of the stereo page: visible after a movement, tap or key, hidden after 8 s without any. */
import { h, useLayoutEffect, useSignal } from "../preact.js";
import { Segments, Selection, Toggle } from "../widgets/fields.js";
import { unrounded } from "../widgets/format.js";
import { Setting, Stepper } from "../widgets/setting.js";
import { t } from "../texts.js";
import { choose, chosen, CONVERGENCES, MODES, MOST_APART } from "./settings.js";

const VISIBLE_FOR = 8000; // ms

/** @param {{root: HTMLElement}} bar root: of the page */
export function ControlBar({ root }) {
  const { mode, apart, convergence, swapped, split } = chosen.value;
  useLayoutEffect(() => hideWhenQuiet(root), []);
  return h(
    "section",
    { class: "hud stereo-bar", "aria-label": t("stereo-settings") },
    h(
      Setting,
      { title: t("stereo-mode"), hint: t(`stereo-mode-${mode}-why`) },
      h(Segments, {
        label: t("stereo-mode"),
        options: MODES.map((value) => ({ value, label: t(`stereo-mode-${value}`) })),
        chosen: mode,
        onChange: (name) => choose({ mode: MODES.find((value) => value === name) }),
      }),
    ),
    h(
      Setting,
      { title: t("stereo-apart"), hint: t("stereo-apart-why") },
      h(Stepper, {
        label: t("stereo-apart"),
        value: apart,
        low: 0,
        high: MOST_APART,
        step: 1,
        digits: 0,
        unit: "mm",
        onChange: (value) => choose({ apart: value }),
      }),
    ),
    h(
      Setting,
      { title: t("stereo-convergence"), hint: t("stereo-convergence-why") },
      h(Selection, {
        options: CONVERGENCES.map((value) => ({
          value,
          label: value === "Infinity" ? t("stereo-far") : `${unrounded(Number(value))} m`,
        })),
        chosen: convergence,
        onChange: (metres) => choose({ convergence: CONVERGENCES.find((value) => value === metres) }),
        "aria-label": t("stereo-convergence"),
      }),
    ),
    h(
      Setting,
      { title: t("stereo-swap-title"), hint: t("stereo-swap-why") },
      h(Toggle, { label: t("stereo-swap"), on: swapped, onChange: (isOn) => choose({ swapped: isOn }) }),
    ),
    mode !== "red-cyan" &&
      h(
        Setting,
        { title: t("stereo-split-title"), hint: t("stereo-split-why") },
        h(Toggle, { label: t("stereo-split"), on: split, onChange: (isOn) => choose({ split: isOn }) }),
      ),
    document.fullscreenEnabled &&
      h(Setting, { title: t("stereo-full"), hint: t("stereo-full-why") }, h(FullScreenButton, {})),
    h("p", { class: "comfort" }, t("stereo-comfort")),
  );
}

function FullScreenButton() {
  const isFull = useSignal(Boolean(document.fullscreenElement));
  useLayoutEffect(() => {
    const look = () => void (isFull.value = Boolean(document.fullscreenElement));
    document.addEventListener("fullscreenchange", look);
    return () => document.removeEventListener("fullscreenchange", look);
  }, []);
  const change = () => {
    const root = document.documentElement;
    const changed = document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen();
    changed.catch(() => null); // the browser shows the reason
  };
  return h(
    "button",
    { type: "button", class: "btn", onClick: change },
    t(isFull.value ? "stereo-full-leave" : "stereo-full-enter"),
  );
}

/** Hide the bar and the pointer while nothing is done; return what ends this. @param {HTMLElement} root */
function hideWhenQuiet(root) {
  const gone = new AbortController();
  let timer = 0;
  const show = () => {
    root.classList.remove("is-quiet");
    clearTimeout(timer);
    timer = setTimeout(() => root.classList.add("is-quiet"), VISIBLE_FOR);
  };
  for (const event of ["pointermove", "pointerdown", "keydown", "focusin", "change"])
    document.addEventListener(event, show, { signal: gone.signal });
  show();
  return () => {
    clearTimeout(timer);
    gone.abort();
    root.classList.remove("is-quiet");
  };
}
