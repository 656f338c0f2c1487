/**
 * The head tracker: which one, how it is, and what is straight ahead.
 * @import { App } from "../../main.js"
 * @import { Body } from "types/requests"
 * @import { FileView } from "types/api"
 * @import { Equipment } from "types/documents"
 * @import { Attributes, Child } from "types/dom"
 * @typedef {Body<"put", "/equipment/head">["config"]} HeadRequest
 * @typedef {{kind?: string, host?: string, port?: number, device?: string, baud?: number, address?: number | null, file?: string}} HeadSettings
 * @typedef {{fields: Child, config: () => HeadRequest}} Part the settings of one kind of head tracker
 */
import { limitsOf, numberLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices, field } from "../../widgets/fields.js";
import { addFile, fileField } from "./signal_files.js";
import { endTabletHead, tabletHead } from "./tablet_head.js";

const KINDS = ["none", "opentrack", "freepie", "flock_of_birds", "tablet", "recorded", "simulator"];
/** @type {Record<string, number>} */
/** @type {Record<string, string>} */
const OVER_NETWORK = { opentrack: "OpentrackConfig", freepie: "FreepieConfig" };

/** In one line what is in use. @param {HeadSettings | null} config */
export function headWords(config) {
  return t(`head-${config?.kind ?? "none"}-now`, { port: config?.port, device: config?.device, file: config?.file });
}

/**
 * @param {App} app @param {Equipment} equipment @param {(config: HeadRequest) => Promise<void>} onUse rejects with a sentence
 * @param {{kind: string, onKind: (kind: string) => void}} shown the kind whose settings are shown
 */
export function headForm(app, equipment, onUse, { kind: first, onKind }) {
  const { config: now } = equipment.head;
  const settings = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @type {Part["config"]} */
  let read = () => null;
  /** @param {string} kind */
  const choose = (kind) => {
    onKind(kind);
    const parts = fieldsOf(app, kind, now?.kind === kind ? now : null, equipment.files);
    read = parts.config;
    put(settings, parts.fields);
  };
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      await onUse(read());
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  choose(first || now?.kind || "none");
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    choices(
      t("head-title"),
      KINDS.map((kind) => ({ value: kind, label: t(`head-${kind}`), hint: t(`head-${kind}-hint`) })),
      first || now?.kind || "none",
      choose,
    ),
    settings,
    problem,
    h("button", { class: "btn go" }, t("source-use")),
  );
}

/** What is asked live of the tracker in use. @param {App} app @param {Equipment["head"]} head */
export function headActions(app, head) {
  if (head.config?.kind !== "tablet") endTabletHead();
  if (!head.config) return null;
  const ahead = () =>
    app.toasts.attempt(async () => {
      await app.api.post("/equipment/head/ahead", {});
      app.toasts.show(t("head-ahead-done"));
    });
  return h(
    "div",
    { class: "stack" },
    head.config.kind === "tablet" && tabletHead(app),
    h("button", { type: "button", class: "btn", onclick: ahead }, t("head-ahead")),
  );
}

/**
 * The fields of one kind of head tracker.
 * @param {App} app @param {string} kind @param {HeadSettings | null} now @param {FileView[]} files @returns {Part}
 */
function fieldsOf(app, kind, now, files) {
  /** @param {string} label @param {string | number} value @param {Attributes} [more] */
  const input = (label, value, more = {}) => {
    const element = h("input", { type: "text", value, required: true, autocomplete: "off", ...more });
    return { element: field(t(label), element), read: () => element.value.trim() };
  };
  if (kind in OVER_NETWORK) {
    const host = input("source-host", now?.host ?? "127.0.0.1");
    const port = input("source-port", now?.port ?? Number(limitsOf(OVER_NETWORK[kind], "port").usual), {
      type: "number",
      ...numberLimits(OVER_NETWORK[kind], "port"),
    });
    const config = () => ({ kind, host: host.read(), port: Number(port.read()) });
    return {
      fields: [h("div", { class: "columns" }, host.element, port.element)],
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
    const heads = files.filter((file) => file.kind === "head");
    // Without a file, the server says what is missing.
    return { fields: [fileField(heads, config), addFile(app)], config: () => /** @type {HeadRequest} */ (config) };
  }
  if (kind === "none") return { fields: [], config: () => null };
  const config = kind === "simulator" ? { kind, seed: 1 } : { kind };
  return { fields: [], config: () => /** @type {HeadRequest} */ (config) };
}
