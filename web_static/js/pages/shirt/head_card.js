/**
 * The head tracker: which one, how it is, and what is straight ahead.
 * @import { ShirtStore } from "./store.js"
 * @import { Body } from "types/requests"
 * @import { ComponentChildren } from "../../preact.js"
 * @typedef {Body<"put", "/equipment/head">["config"]} HeadRequest
 * @typedef {{kind?: string, host?: string, port?: number, device?: string, baud?: number, address?: number | null, file?: string}} HeadSettings
 * @typedef {{fields: ComponentChildren, config: () => HeadRequest}} Part the settings of one kind of head tracker
 */
import { limitsOf, numberLimits } from "../../reference.js";
import { Fragment, h, useLayoutEffect, useMemo, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Choices, Field } from "../../widgets/fields.js";
import { ChoiceForm } from "./choice_form.js";
import { AddFile, FileField } from "./signal_files.js";
import { endTabletHead, TabletHead } from "./tablet_head.js";

const KINDS = ["none", "opentrack", "freepie", "flock_of_birds", "tablet", "recorded", "simulator"];
/** @type {Record<string, string>} */
const OVER_NETWORK = { opentrack: "OpentrackConfig", freepie: "FreepieConfig" };

/** In one line what is in use. @param {HeadSettings | null} config */
export function headWords(config) {
  return t(`head-${config?.kind ?? "none"}-now`, { port: config?.port, device: config?.device, file: config?.file });
}

/** @param {{store: ShirtStore, onUse: (config: HeadRequest) => Promise<void>}} form onUse: rejects with a sentence */
export function HeadForm({ store, onUse }) {
  const now = useMemo(() => /** @type {HeadSettings | null} */ (store.equipment.peek().head.config), []);
  const kind = useSignal(now?.kind ?? "none");
  const part = useMemo(() => partOf(store, kind.value, now?.kind === kind.value ? now : null), [kind.value]);
  return h(
    ChoiceForm,
    {
      choices: h(Choices, {
        label: t("head-title"),
        options: KINDS.map((value) => ({ value, label: t(`head-${value}`), hint: t(`head-${value}-hint`) })),
        chosen: kind.value,
        onChange: (/** @type {string} */ chosen) => void (kind.value = chosen),
      }),
      onUse: () => onUse(part.config()),
    },
    h(Fragment, { key: kind.value }, part.fields),
  );
}

/** What is asked live of the tracker in use. @param {{store: ShirtStore}} actions */
export function HeadActions({ store: { app, equipment } }) {
  const kind = equipment.value.head.config?.kind;
  useLayoutEffect(() => {
    if (kind !== "tablet") endTabletHead();
  }, [kind]);
  if (!kind) return null;
  const ahead = () =>
    app.toasts.attempt(async () => {
      await app.api.post("/equipment/head/ahead", {});
      app.toasts.show(t("head-ahead-done"));
    });
  return h(
    "div",
    { class: "stack" },
    kind === "tablet" && h(TabletHead, { app }),
    h("button", { type: "button", class: "btn", onClick: ahead }, t("head-ahead")),
  );
}

/**
 * The fields of one kind of head tracker, and what reads them.
 * @param {ShirtStore} store @param {string} kind @param {HeadSettings | null} now @returns {Part}
 */
function partOf({ app, equipment }, kind, now) {
  /** @param {string} label @param {string | number} value @param {object} [more] */
  const input = (label, value, more = {}) => {
    let typed = String(value);
    const onInput = (/** @type {Event} */ { currentTarget }) =>
      void (typed = /** @type {HTMLInputElement} */ (currentTarget).value.trim());
    const attributes = { type: "text", defaultValue: value, required: true, autocomplete: "off", onInput, ...more };
    return { element: h(Field, { label: t(label) }, h("input", attributes)), read: () => typed };
  };
  if (kind in OVER_NETWORK) {
    const host = input("source-host", now?.host ?? "127.0.0.1");
    const port = input("source-port", now?.port ?? Number(limitsOf(OVER_NETWORK[kind], "port").usual), {
      type: "number",
      ...numberLimits(OVER_NETWORK[kind], "port"),
    });
    const config = () => ({ kind, host: host.read(), port: Number(port.read()) });
    return {
      fields: h("div", { class: "columns" }, host.element, port.element),
      config: () => /** @type {HeadRequest} */ (config()),
    };
  }
  if (kind === "flock_of_birds") {
    const device = input("head-device", now?.device ?? "/dev/ttyUSB0");
    const baud = input("head-baud", now?.baud ?? Number(limitsOf("FlockOfBirdsConfig", "baud").usual), {
      type: "number",
      ...numberLimits("FlockOfBirdsConfig", "baud"),
    });
    const address = input("head-address", now?.address ?? "", {
      type: "number",
      ...numberLimits("FlockOfBirdsConfig", "address"),
      required: false,
    });
    /** @returns {HeadRequest} */
    const config = () => ({
      kind,
      device: device.read(),
      baud: Number(baud.read()),
      address: address.read() ? Number(address.read()) : null,
    });
    return {
      fields: [
        h("div", { class: "columns" }, device.element, baud.element, address.element),
        h("p", { class: "quiet small" }, t("head-address-hint")),
      ],
      config,
    };
  }
  if (kind === "recorded") {
    const config = { kind, file: now?.file, loop: true };
    const Heads = () => h(FileField, { files: equipment.value.files.filter((file) => file.kind === "head"), config });
    // Without a file, the server says what is missing.
    return { fields: [h(Heads, {}), h(AddFile, { app })], config: () => /** @type {HeadRequest} */ (config) };
  }
  if (kind === "none") return { fields: null, config: () => null };
  const config = kind === "simulator" ? { kind, seed: 1 } : { kind };
  return { fields: null, config: () => /** @type {HeadRequest} */ (config) };
}
