/**
 * Where the shirt's signals come from: the form, and the configuration that it makes.
 * @import { App } from "../../main.js"
 * @import { Body } from "types/requests"
 * @import { FileView, ShirtLayout } from "types/api"
 * @import { Equipment } from "types/documents"
 * @import { Child } from "types/dom"
 * @typedef {Body<"put", "/equipment/shirt">} ShirtRequest
 * @typedef {{fields: Child, config: () => Promise<ShirtRequest>}} Part the settings of one kind of shirt
 */
import { limitsOf, numberLimits } from "../../reference.js";
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices, field, hiddenFileInput, segments, selection, stepper, toggle } from "../../widgets/fields.js";
import { size } from "../../widgets/format.js";
import { sendUnderName } from "../../widgets/same_name.js";

const RATES = [50, 100, 200, 500, 1000]; // Hz; 100 is the rate of the shirts that there are
const REPLAYED = new Set(["signals", "recording"]);

/**
 * In one line what is in use.
 * @param {{kind: string, sample_rate?: number, file?: string, port?: number} | null} shirt
 */
export function sourceWords(shirt) {
  if (!shirt) return t("source.none");
  return t(`source.${shirt.kind}.now`, { rate: shirt.sample_rate, file: shirt.file, port: shirt.port });
}

/**
 * @param {App} app @param {Equipment} equipment
 * @param {(config: ShirtRequest) => Promise<void>} onUse rejects with a sentence
 * @param {{kind: string, onKind: (kind: string) => void}} shown the kind whose settings are shown
 */
export function sourceForm(app, equipment, onUse, { kind: first, onKind }) {
  /** @type {Record<string, (app: App, equipment: Equipment) => Part>} */
  const made = { simulator, replay, udp };
  /** @param {boolean} simulated */
  const kinds = (simulated) =>
    equipment.shirts
      .filter((one) => one.simulated === simulated && one.kind in made)
      .map(({ kind }) => ({ value: kind, label: t(`source.${kind}`), hint: t(`source.${kind}.hint`) }));
  const settings = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @type {Part | null} */
  let parts = null;
  /** @param {string} kind */
  const show = (kind) => {
    onKind(kind);
    parts = made[kind](app, equipment);
    put(settings, parts.fields);
    use.hidden = false;
  };
  /** @param {string} kind */
  const choose = (kind) => {
    show(kind);
    use.scrollIntoView({ block: "nearest" }); // it is the next step
  };
  /** @param {SubmitEvent} event */
  const submit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    try {
      if (parts) await onUse(await parts.config());
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  const use = h("button", { class: "btn go", hidden: true }, t("source.use"));
  if (first) show(first);
  return h(
    "form",
    { class: "stack", onsubmit: submit },
    choices(
      t("source.title"),
      [
        { words: t("source.worn"), options: kinds(false) },
        { words: t("source.practice"), options: kinds(true) },
      ],
      first,
      choose,
    ),
    settings,
    problem,
    use,
  );
}

/** @param {App} _app @param {Equipment} equipment @returns {Part} */
function simulator(_app, { shirt, layout }) {
  const now = shirt?.kind === "simulator" ? shirt : { sample_rate: 100, seed: 1, dead_channels: [], layout: null };
  /** @type {Extract<ShirtRequest, {kind: "simulator"}>} */
  const config = {
    kind: "simulator",
    sample_rate: now.sample_rate,
    seed: now.seed,
    layout: now.layout,
    dead_channels: now.dead_channels,
  };
  const rates = [...new Set([...RATES, now.sample_rate])].sort((a, b) => a - b);
  const names = shirt?.kind === "simulator" ? (layout?.channels ?? []).map(({ name }) => name) : [];
  // Two sensors of different joints, so that the demonstration shows what left-out sensors do without spoiling a joint.
  const broken =
    names.length > 2 ? [names[Math.floor(names.length / 3)], names[Math.floor((3 * names.length) / 4)]] : [];
  const fields = [
    field(
      t("source.rate"),
      selection(
        rates.map((rate) => ({ value: String(rate), label: t("source.rate.unit", { rate }) })),
        String(now.sample_rate),
        (rate) => (config.sample_rate = Number(rate)),
      ),
    ),
    h(
      "div",
      { class: "row" },
      h("b", { class: "small" }, t("source.seed")),
      stepper({
        label: t("source.seed"),
        value: now.seed,
        low: 1,
        high: 999,
        step: 1,
        digits: 0,
        unit: "",
        onChange: (seed) => (config.seed = seed),
      }),
    ),
    broken.length > 0 &&
      h(
        "div",
        { class: "row" },
        h("b", { class: "small" }, t("source.sensors")),
        segments(
          t("source.sensors"),
          [
            { value: "", label: t("source.sensors.all") },
            { value: "broken", label: t("source.sensors.broken") },
          ],
          now.dead_channels.length ? "broken" : "",
          (choice) => (config.dead_channels = choice ? broken : []),
        ),
      ),
  ];
  return { fields, config: async () => config };
}

/** @param {App} app @param {Equipment} equipment @returns {Part} */
function replay(app, { shirt, files }) {
  const now = shirt?.kind === "replay" ? shirt : null;
  /** @type {{kind: "replay", file: string | undefined, loop: boolean}} */
  const config = { kind: "replay", file: now?.file, loop: now?.loop ?? true };
  return {
    fields: [
      fileField(
        files.filter(({ kind }) => REPLAYED.has(kind)),
        config,
      ),
      toggle(t("source.loop"), config.loop, (loop) => (config.loop = loop)),
      addFile(app),
    ],
    config: async () => /** @type {ShirtRequest} */ (config), // without a file, the server says what is missing
  };
}

/** @param {App} _app @param {Equipment} equipment @returns {Part} */
function udp(_app, { shirt, layout, shirt_keys: keys }) {
  const now = shirt?.kind === "udp" ? shirt : { host: "127.0.0.1", port: Number(limitsOf("UdpConfig", "port").usual), sample_rate: Number(limitsOf("UdpConfig", "sample_rate").usual), key_file: null };
  const host = h("input", { type: "text", value: now.host, required: true, autocomplete: "off" });
  const port = h("input", { type: "number", value: now.port, ...numberLimits("UdpConfig", "port"), required: true });
  const rate = h("input", { type: "number", value: now.sample_rate, ...numberLimits("UdpConfig", "sample_rate"), required: true });
  const file = h("input", { type: "file", accept: ".json,application/json" });
  let key = now.key_file && keys.includes(now.key_file) ? now.key_file : "";
  /** @returns {Promise<ShirtRequest>} */
  const config = async () => ({
    kind: "udp",
    host: host.value.trim(),
    port: Number(port.value),
    sample_rate: Number(rate.value),
    layout: file.files?.[0] ? await readDocument(file.files[0]) : (layout ?? undefined), // without one: the standard shirt
    key_file: key || null,
  });
  return {
    fields: [
      h(
        "div",
        { class: "columns" },
        field(t("source.host"), host),
        field(t("source.port"), port),
        field(t("source.rate"), rate),
      ),
      field(t("source.layout"), file, t("source.layout.hint")),
      field(
        t("source.key"),
        selection(
          ["", ...keys].map((name) => ({ value: name, label: name || t("source.key.none") })),
          key,
          (name) => (key = name),
        ),
        t("source.key.hint"),
      ),
    ],
    config,
  };
}

/** @param {File} file @returns {Promise<ShirtLayout>} as far as the server accepts it */
async function readDocument(file) {
  try {
    return JSON.parse(await file.text());
  } catch {
    throw new Error(t("source.layout.wrong", { file: file.name }));
  }
}

/** A selection among files that lie on the machine. @param {FileView[]} files @param {{file?: string}} config */
export function fileField(files, config) {
  if (!files.length) return h("p", { class: "quiet small" }, t("source.no-file"));
  const chosen = files.find(({ name }) => name === config.file)?.name ?? files[0].name;
  config.file = chosen;
  const options = files.map((file) => ({
    value: file.name,
    label: t("source.file.option", { name: file.name, size: size(file.size) }),
  }));
  return field(
    t("source.file"),
    selection(options, chosen, (name) => (config.file = name)),
  );
}

/** A button that brings a file to the machine; the page reads the equipment again by itself. @param {App} app */
export function addFile(app) {
  const input = hiddenFileInput(".csv,.parquet", async (file) => {
    app.toasts.show(t("source.adding", { file: file.name }));
    await app.toasts.attempt(async () => {
      const equipment = await sendUnderName(app.question, (sameName) =>
        app.api.upload(`/equipment/files?same_name=${sameName}`, file),
      );
      if (equipment) {
        app.dispatchEvent(new CustomEvent("equipment", { detail: equipment }));
        app.toasts.show(t("source.added", { file: file.name }));
      }
    });
    input.value = "";
  });
  return h(
    "div",
    { class: "spread" },
    h("button", { type: "button", class: "btn", onclick: () => input.click() }, t("source.add")),
    input,
    h("span", { class: "quiet small" }, t("source.add.hint")),
  );
}
