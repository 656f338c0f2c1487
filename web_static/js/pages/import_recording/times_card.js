/** Which stream or sheet of the file is read, which column is the time, in which unit, and at which sample rate. */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";

const UNITS = ["s", "ms", "us", "ns", "min", "h", "d"];
const AS_IT_SAYS = "auto"; // options that are no column: others have a number
const NONE = "none";
const WORKBOOK = "XLSX";

/**
 * @typedef {import("./store.js").ImportStore} ImportStore
 * @typedef {import("types/api").RecordingOverview} RecordingOverview
 * @param {{store: ImportStore, overview: RecordingOverview}} card
 */
export function TimesCard({ store: { corrections, correct }, overview }) {
  const { kind, parts, columns, time, unit, rate } = overview;
  const { value: corrected } = corrections;
  const names = columns.filter(({ least }) => least !== null).map(({ name }) => name);
  const asItSays = { value: AS_IT_SAYS, label: t("import-recording-as-it-says") };
  const partNames = parts.map(({ name }) => name);
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("import-recording-times")),
    parts.length > 0 &&
      h(
        Field,
        { label: t("import-recording-part") },
        h(Selection, {
          options: [
            { value: AS_IT_SAYS, label: t(`import-recording-part-${kind === WORKBOOK ? "largest" : "all"}`) },
            ...numbered(partNames),
          ],
          chosen: corrected.part === null ? AS_IT_SAYS : String(partNames.indexOf(corrected.part)),
          onChange: (value) =>
            correct({ part: named(partNames, value), time: null, unit: null, rate: null, channels: null }),
        }),
      ),
    h(
      Field,
      { label: t("import-recording-time") },
      h(Selection, {
        options: [asItSays, { value: NONE, label: t("import-recording-time-none") }, ...numbered(names)],
        chosen: chosenTime(names, corrected.time ?? time),
        onChange: (value) => correct({ time: value === NONE ? "" : named(names, value), unit: null, rate: null }),
      }),
    ),
    corrected.time !== "" &&
      h(
        Field,
        { label: t("import-recording-unit") },
        h(Selection, {
          options: [asItSays, ...UNITS.map((one) => ({ value: one, label: t(`import-recording-unit-${one}`) }))],
          chosen: corrected.unit ?? unit ?? AS_IT_SAYS,
          onChange: (value) => correct({ unit: value === AS_IT_SAYS ? null : value }),
        }),
      ),
    h(
      Field,
      { label: t("import-recording-rate-by-hand"), hint: t("import-recording-rate-hint") },
      h("input", {
        type: "number",
        step: "any", // whether such a rate is possible, the server says
        inputmode: "decimal",
        value: corrected.rate ?? rate ?? "",
        onChange: (/** @type {Event} */ { currentTarget }) => {
          const input = /** @type {HTMLInputElement} */ (currentTarget);
          if (input.reportValidity()) correct({ rate: input.value === "" ? null : Number(input.value) });
        },
      }),
    ),
  );
}

/** Names as options, each under its number: a name may be any text. @param {string[]} names */
function numbered(names) {
  return names.map((label, index) => ({ value: String(index), label }));
}

/** The name of an option; null: as the file says. @param {string[]} names @param {string} value */
function named(names, value) {
  return value === AS_IT_SAYS ? null : names[Number(value)];
}

/** @param {string[]} names @param {string | null} time */
function chosenTime(names, time) {
  if (time === null) return AS_IT_SAYS;
  return time === "" ? NONE : String(names.indexOf(time));
}
