/**
 * The log, for owners: who, when, what; filtered by person and patient, exported with its chain, checked by a button.
 * @import { LogView } from "types/api"
 */
import { ApiError, FORBIDDEN } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { exactMoment } from "../../widgets/format.js";
import { scrollTable } from "../../widgets/scroll_table.js";
import { logCard } from "./log_card.js";
import { detailWords, whatWords } from "./log_details.js";

const ALL = "";

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  if (app.me?.role !== "owner") throw new ApiError(t("log-owner"), FORBIDDEN);
  const [first, patients] = await Promise.all([app.api.get("/log"), app.api.get("/patients")]);
  if (signal.aborted) return;
  const codes = new Map(patients.map(({ id, code }) => [id, code]));
  const rows = h("tbody", {});
  const more = h("button", { type: "button", class: "btn" }, t("log-more"));
  const none = h("p", { class: "quiet", role: "status" });
  let [person, patient] = [ALL, ALL];
  /** @type {number | null} id of the oldest row that is shown */
  let oldest = null;

  /** @param {LogView} view */
  const append = ({ entries, has_more: hasMore }) => {
    rows.append(...entries.map((entry) => row(entry, codes)));
    oldest = entries.at(-1)?.id ?? oldest;
    more.hidden = !hasMore;
    none.textContent = rows.childElementCount ? "" : t("log-none");
  };
  /** @param {number | null} before */
  const read = (before) =>
    app.toasts.attempt(async () => {
      const asked = { person, patient, before: before === null ? ALL : String(before) };
      const chosen = new URLSearchParams(Object.entries(asked).filter(([, value]) => value !== ALL));
      const view = await app.api.get(`/log?${chosen}`);
      if (signal.aborted) return;
      if (before === null) put(rows);
      append(view);
    });
  more.addEventListener("click", () => read(oldest));
  const everybody = [
    { value: ALL, label: t("log-everybody") },
    ...first.people.map((name) => ({ value: name, label: name })),
  ];
  const everyPatient = [
    { value: ALL, label: t("log-every-patient") },
    ...patients.map(({ id, code }) => ({ value: String(id), label: code })),
  ];
  const choosePerson = selection(everybody, ALL, (value) => {
    person = value;
    read(null);
  });
  const choosePatient = selection(everyPatient, ALL, (value) => {
    patient = value;
    read(null);
  });
  append(first);
  /** @param {"csv" | "jsonl"} form */
  const exportLink = (form) =>
    h("a", { class: "btn small", href: `/api/v1/log/export?form=${form}`, download: "" }, t(`log-export-${form}`));
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("rail-log")),
      h("p", { class: "lead" }, t("log-lead")),
      logCard(app, signal),
      h(
        "section",
        { class: "card log-rows" },
        h(
          "div",
          { class: "spread log-filters" },
          field(t("log-person"), choosePerson),
          field(t("log-patient"), choosePatient),
        ),
        scrollTable(
          t("rail-log"),
          "log-table",
          h(
            "thead",
            {},
            h(
              "tr",
              {},
              ["when", "who", "what", "details"].map((column) => h("th", { scope: "col" }, t(`log-${column}`))),
            ),
          ),
          rows,
        ),
        none,
        more,
      ),
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

/** @param {LogView["entries"][number]} entry @param {Map<number, string>} codes */
function row({ at, person, what, details }, codes) {
  const moment = h("time", { datetime: at }, exactMoment(at));
  return h(
    "tr",
    {},
    h("td", {}, moment),
    h("td", {}, person ?? t("log-program")),
    h("td", {}, whatWords(what)),
    h("td", { class: "quiet" }, detailWords(details, codes, what)),
  );
}
