/**
 * The log, for owners: who, when, what; filtered by person and patient, exported with its chain, checked by a button.
 * @import { LogView } from "types/api"
 */
import { ApiError, FORBIDDEN } from "../../api.js";
import { drawPage, Fragment, h, signal, useFocusWithin } from "../../preact.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { exactMoment } from "../../widgets/format.js";
import { ScrollTable } from "../../widgets/scroll_table.js";
import { LogCard } from "./log_card.js";
import { detailWords, whatWords } from "./log_details.js";

const ALL = "";
const COLUMNS = /** @type {const} */ (["when", "who", "what", "details"]);

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  if (app.me?.role !== "owner") throw new ApiError(t("log-owner"), FORBIDDEN);
  const [first, patients] = await Promise.all([app.api.get("/log"), app.api.get("/patients")]);
  if (left.aborted) return;
  const codes = new Map(patients.map(({ id, code }) => [id, code]));
  const view = signal(first);
  const chosen = signal({ person: ALL, patient: ALL });
  /** @param {LogView["entries"]} [shown] rows that stay, above older ones */
  const read = (shown = []) =>
    app.toasts.attempt(async () => {
      const asked = { ...chosen.value, before: String(shown.at(-1)?.id ?? ALL) };
      const query = new URLSearchParams(Object.entries(asked).filter(([, value]) => value !== ALL));
      const now = await app.api.get(`/log?${query}`);
      view.value = { ...now, entries: [...shown, ...now.entries] };
    });
  /** @param {keyof typeof chosen.value} name @param {{value: string, label: string}[]} options */
  const filter = (name, options) =>
    h(
      Field,
      {
        label: t(`log-${name}`),
      },
      h(Selection, {
        options,
        chosen: chosen.value[name],
        onChange: (value) => {
          chosen.value = { ...chosen.value, [name]: value };
          read();
        },
      }),
    );
  const persons = first.people.map((name) => ({ value: name, label: name }));
  const codeOptions = patients.map(({ id, code }) => ({ value: String(id), label: code }));
  const Filters = () =>
    h(
      "div",
      { class: "spread log-filters" },
      filter("person", [{ value: ALL, label: t("log-everybody") }, ...persons]),
      filter("patient", [{ value: ALL, label: t("log-every-patient") }, ...codeOptions]),
    );
  const Rows = () => {
    useFocusWithin(".log-rows"); // the button for older rows goes with the last of them
    const { entries, has_more: hasMore } = view.value;
    return h(
      Fragment,
      {},
      h(
        ScrollTable,
        { label: t("rail-log"), kind: "log-table" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            COLUMNS.map((column) => h("th", { key: column, scope: "col" }, t(`log-${column}`))),
          ),
        ),
        h(
          "tbody",
          {},
          entries.map((entry) => h(Row, { key: entry.id, entry, codes })),
        ),
      ),
      h("p", { class: "quiet", role: "status" }, !entries.length && t("log-none")),
      h("button", { type: "button", class: "btn", hidden: !hasMore, onClick: () => read(entries) }, t("log-more")),
    );
  };
  /** @param {"csv" | "jsonl"} form */
  const exportLink = (form) =>
    h("a", { class: "btn small", href: `/api/v1/log/export?form=${form}`, download: "" }, t(`log-export-${form}`));
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("rail-log")),
      h("p", { class: "lead" }, t("log-lead")),
      h(LogCard, { app }),
      h("section", { class: "card log-rows" }, h(Filters, {}), h(Rows, {})),
      h(
        "p",
        { class: "spread after-list" },
        exportLink("csv"),
        exportLink("jsonl"),
        h("a", { class: "btn small", href: "#/settings" }, t("people-back")),
      ),
    ),
  );
}

/** @param {{entry: LogView["entries"][number], codes: Map<number, string>}} row codes: of patients, by their ids */
function Row({ entry: { at, person, what, details }, codes }) {
  return h(
    "tr",
    {},
    h("td", {}, h("time", { datetime: at }, exactMoment(at))),
    h("td", {}, person ?? t("log-program")),
    h("td", {}, whatWords(what)),
    h("td", { class: "quiet" }, detailWords(details, codes, what)),
  );
}
