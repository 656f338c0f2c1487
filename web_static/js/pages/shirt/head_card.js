/** The head tracker: which one, how it is, and what is straight ahead. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices, field } from "../../widgets/fields.js";
import { addFile, fileField } from "./source_form.js";
import { endTabletHead, tabletHead } from "./tablet_head.js";

const KINDS = ["none", "opentrack", "freepie", "flock_of_birds", "tablet", "recorded", "simulator"];
const PORTS = { opentrack: 4242, freepie: 5555 };
const BAUD = 115200;

/** In one line what is in use. @param {any} config */
export function headWords(config) {
  return t(`head.${config?.kind ?? "none"}.now`, { port: config?.port, device: config?.device, file: config?.file });
}

/**
 * @param {import("../../main.js").App} app @param {any} equipment @param {(config: any) => Promise<void>} onUse rejects with a sentence
 * @param {{kind: string, onKind: (kind: string) => void}} shown the kind whose settings are shown
 */
export function headForm(app, equipment, onUse, { kind: first, onKind }) {
  const { config: now } = equipment.head;
  const settings = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  let read = () => null;
  const choose = (kind) => {
    onKind(kind);
    const parts = fieldsOf(app, kind, now?.kind === kind ? now : null, equipment.files);
    read = parts.config;
    put(settings, parts.fields);
  };
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      await onUse(read());
    } catch (error) {
      problem.textContent = error.message;
    }
  };
  choose(first || now?.kind || "none");
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    choices(
      t("head.title"),
      KINDS.map((kind) => ({ value: kind, label: t(`head.${kind}`), hint: t(`head.${kind}.hint`) })),
      first || now?.kind || "none",
      choose,
    ),
    settings,
    problem,
    h("button", { class: "btn go" }, t("source.use")),
  );
}

/** What is asked live of the tracker in use. @param {import("../../main.js").App} app @param {any} head */
export function headActions(app, head) {
  if (head.config?.kind !== "tablet") endTabletHead();
  if (!head.config) return null;
  const ahead = async () => {
    try {
      await app.api.post("/equipment/head/ahead", {});
      app.toasts.show(t("head.ahead.done"));
    } catch (error) {
      app.toasts.show(error.message);
    }
  };
  return h(
    "div",
    { class: "stack" },
    head.config.kind === "tablet" && tabletHead(app),
    h("button", { type: "button", class: "btn", onclick: ahead }, t("head.ahead")),
  );
}

function fieldsOf(app, kind, now, files) {
  const input = (label, value, more = {}) => {
    const element = h("input", { type: "text", value, required: true, autocomplete: "off", ...more });
    return { element: field(t(label), element), read: () => element.value.trim() };
  };
  if (kind in PORTS) {
    const host = input("source.host", now?.host ?? "127.0.0.1");
    const port = input("source.port", now?.port ?? PORTS[kind], { type: "number", min: 1, max: 65535 });
    const config = () => ({ kind, host: host.read(), port: Number(port.read()) });
    return { fields: [h("div", { class: "columns" }, host.element, port.element)], config };
  }
  if (kind === "flock_of_birds") {
    const device = input("head.device", now?.device ?? "/dev/ttyUSB0");
    const baud = input("head.baud", now?.baud ?? BAUD, { type: "number", min: 2400, max: 115200 });
    const address = input("head.address", now?.address ?? "", { type: "number", min: 1, max: 14, required: false });
    const config = () => ({
      kind,
      device: device.read(),
      baud: Number(baud.read()),
      address: address.read() ? Number(address.read()) : null,
    });
    return {
      fields: [
        h("div", { class: "columns" }, device.element, baud.element, address.element),
        h("p", { class: "quiet small" }, t("head.address.hint")),
      ],
      config,
    };
  }
  if (kind === "recorded") {
    const config = { kind, file: now?.file, loop: true };
    const heads = files.filter((file) => file.kind === "head");
    return { fields: [fileField(heads, config), addFile(app)], config: () => config };
  }
  if (kind === "none") return { fields: [], config: () => null };
  return { fields: [], config: () => (kind === "simulator" ? { kind, seed: 1 } : { kind }) };
}
