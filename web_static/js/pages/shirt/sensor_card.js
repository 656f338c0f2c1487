/** One sensor in words, with its live trace, and whether it is used. */
import { h, useComputed, useMemo, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Toggle } from "../../widgets/fields.js";
import { number } from "../../widgets/format.js";
import { sensorName } from "../../widgets/joint_words.js";
import { useUntilGone } from "../../widgets/made.js";
import { drawTraces, QUIET_SPAN } from "../../charts/joint_strips.js";
import { LampPicture } from "./lamps.js";
import { TraceCanvas } from "../../charts/traces.js";

/**
 * @param {{store: import("./store.js").ShirtStore, name: string, index: number, joint: string}} sensor
 *   index: of its channel; joint: as people read it
 */
export function SensorCard({ store, name, index, joint }) {
  const { app, left, live, equipment } = store;
  const canvas = useMemo(
    () => new TraceCanvas({ label: t("sensor-trace", { name: sensorName(name) }), height: 96 }),
    [],
  );
  const place = useRef(/** @type {HTMLDivElement | null} */ (null));
  const value = useSignal("");
  const noise = useComputed(() => t("sensor-noise", { noise: figure(live.value.noise[index]) }));
  const quality = useComputed(() => live.value.qualities[index] ?? "silent").value;
  useUntilGone(left, (signal) => {
    const setFloor = () => (canvas.floor = QUIET_SPAN * (app.live.noise[index] ?? 0));
    setFloor();
    app.live.addEventListener("quality", setFloor, { signal });
    app.live.addEventListener(
      "tick",
      ({ detail }) => (value.value = t("sensor-now", { value: figure(detail.values?.[index]) })),
      { signal },
    );
    drawTraces(app.live, [{ canvas, values: (now) => [now.values?.[index] ?? null] }], signal);
    canvas.element.className = "trace large";
    place.current?.append(canvas.element);
  });
  return h(
    "section",
    { class: "card sensor-card" },
    h(
      "div",
      { class: "spread" },
      h(LampPicture, { quality, size: 26 }),
      h(
        "div",
        { class: "grow" },
        h("h2", {}, sensorName(name)),
        h("span", { class: "quiet small" }, t("sensor-joint", { joint })),
      ),
      h("b", {}, t(`quality-${quality}`)),
    ),
    h("div", { ref: place }),
    h("div", { class: "row quiet small" }, h("span", { class: "number" }, value), h("span", {}, noise)),
    // Only the words are live: the figures change all the time.
    h("p", { class: "small", "aria-live": "polite" }, t(`quality-${quality}-words`)),
    h(
      "div",
      { class: "spread" },
      h(Toggle, {
        label: t("sensor-unused"),
        on: equipment.value.unused.includes(name),
        onChange: (isUnused) => store.setUnused(name, isUnused),
      }),
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
