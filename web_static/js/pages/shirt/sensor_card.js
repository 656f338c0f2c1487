/** One sensor in words, with its live trace, and whether it is used. */
import { t } from "../../texts.js";
import { h, put, s, set, write } from "../../widgets/dom.js";
import { toggle } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { sensorName } from "../../widgets/joint_words.js";
import { drawTraces, QUIET_SPAN } from "../../charts/joint_strips.js";
import { LAMP_BOX, lampSign } from "./lamps.js";
import { TraceCanvas } from "../../charts/traces.js";

/**
 * @param {import("../../main.js").App} app
 * @param {{channel: import("types/api").Channel, index: number, joint: string, isUnused: boolean, signal: AbortSignal}} sensor
 * @param {(isUnused: boolean) => void} onUnused
 */
export function sensorCard(app, { channel, index, joint, isUnused, signal }, onUnused) {
  const canvas = new TraceCanvas({ label: t("sensor-trace", { name: sensorName(channel.name) }), height: 96 });
  const lamp = s("svg", { viewBox: LAMP_BOX, width: 26, height: 26, "aria-hidden": "true" });
  const quality = h("b", {});
  const words = h("p", { class: "small", "aria-live": "polite" }); // figures are not live: they change all the time
  const noise = h("span", {});
  const value = h("span", { class: "number" });
  const showQuality = () => {
    const now = app.live.quality[index] ?? "silent";
    if (lamp.dataset.quality !== now) {
      lamp.dataset.quality = now;
      put(lamp, s("g", { class: "sensor", "data-quality": now }, lampSign(now)));
    }
    write(quality, t(`quality-${now}`));
    write(words, t(`quality-${now}-words`));
    canvas.floor = QUIET_SPAN * (app.live.noise[index] ?? 0);
    write(noise, t("sensor-noise", { noise: figure(app.live.noise[index]) }));
  };
  app.live.addEventListener("quality", showQuality, { signal });
  app.live.addEventListener(
    "tick",
    ({ detail }) => write(value, t("sensor-now", { value: figure(detail.values?.[index]) })),
    { signal },
  );
  drawTraces(app.live, [{ canvas, values: (now) => [now.values?.[index] ?? null] }], signal);
  showQuality();
  set(canvas.element, { class: "trace large" });
  return h(
    "section",
    { class: "card sensor-card" },
    h(
      "div",
      { class: "spread" },
      lamp,
      h(
        "div",
        { class: "grow" },
        h("h2", {}, sensorName(channel.name)),
        h("span", { class: "quiet small" }, t("sensor-joint", { joint })),
      ),
      quality,
    ),
    canvas.element,
    h("div", { class: "row quiet small" }, value, noise),
    words,
    h(
      "div",
      { class: "spread" },
      toggle(t("sensor-unused"), isUnused, onUnused),
      h("span", { class: "quiet small" }, t("sensor-unused-hint")),
    ),
  );
}

/** Three significant digits, whatever the unit of the shirt. @param {number | null | undefined} value */
function figure(value) {
  if (typeof value !== "number" || !Number.isFinite(value)) return "–";
  const digits = value === 0 ? 2 : Math.min(5, Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value)))));
  return number(value, digits);
}
