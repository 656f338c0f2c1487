/** Import a recording of another program: what the file holds is confirmed or corrected, then the shirt plays it. */
import { drawFoot, drawPage, Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { FactList } from "../../widgets/fact_list.js";
import { Field } from "../../widgets/fields.js";
import { allOf, number, unrounded } from "../../widgets/format.js";
import { labelsOf } from "../../widgets/joint_words.js";
import { ChannelsCard } from "./channels_card.js";
import { importStore } from "./store.js";
import { TimesCard } from "./times_card.js";

/**
 * @typedef {import("./store.js").ImportStore} ImportStore
 * @typedef {import("types/api").RecordingOverview} RecordingOverview
 */

const TEXT_KIND = "CSV"; // of all tables in text, for the server

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export function show(app, root, { signal: left }) {
  const store = importStore(app, left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: ImportStore}} page */
function Page({ store }) {
  const { overview, problem, isReading, choose } = store;
  /** @param {{currentTarget: HTMLInputElement}} event */
  const onChange = ({ currentTarget }) => choose([...(currentTarget.files ?? [])]);
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("rail-import-recording")),
    h("p", { class: "lead" }, t("import-recording-lead")),
    h(
      "div",
      { class: "stack" },
      h(
        "section",
        { class: "card stack" },
        h(
          Field,
          { label: t("import-recording-files"), hint: t("import-recording-files-hint") },
          h("input", { type: "file", multiple: true, onChange }),
        ),
        h(
          "div",
          {},
          h("p", { role: "status" }, isReading.value && t("import-recording-reading")),
          h("p", { class: "problem", role: "alert" }, problem.value),
        ),
      ),
      overview.value &&
        h(
          Fragment,
          {},
          h(Contents, { store, overview: overview.value }),
          h(
            "div",
            { class: "settings-columns" },
            h(TimesCard, { store, overview: overview.value }),
            h(ChannelsCard, { store, overview: overview.value }),
          ),
        ),
    ),
  );
}

/**
 * What the file holds, and what a person must correct first.
 * @param {{store: ImportStore, overview: RecordingOverview}} contents
 */
function Contents({ store, overview }) {
  const { kind, dialect, rows, seconds, rate, message, problem, joints } = overview;
  const labels = labelsOf(joints);
  const used = [...new Set(store.channels.value.map(({ joint }) => joint))];
  const length =
    seconds === null
      ? t("import-recording-rows", { count: rows ?? 0 })
      : t("import-recording-length-words", { seconds: number(seconds, 1), count: rows ?? 0 });
  const rateWords =
    rate === null ? t("import-recording-rate-open") : t("import-recording-rate-words", { rate: unrounded(rate) });
  const format = kind === TEXT_KIND ? t("import-recording-kind-text") : kind;
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("import-recording-holds")),
    h(FactList, {
      facts: [
        [t("import-recording-kind"), format, dialect || undefined],
        [t("import-recording-length"), length],
        [t("import-recording-rate"), rateWords],
        [t("import-recording-channels"), String(store.channels.value.length)],
        [t("import-recording-joints"), allOf(used.map((joint) => labels[joint] ?? joint))],
      ],
    }),
    h(
      "div",
      {},
      h("p", { class: "problem", role: "alert" }, problem),
      h("p", { role: "status" }, problem ? t("import-recording-correct") : message || t("import-recording-even")),
    ),
  );
}

/** @param {{store: ImportStore}} foot */
function Foot({ store: { overview, channels, isRead, isSending, store } }) {
  const isHidden = !overview.value;
  const isOff = !isRead.value || isSending.value || !channels.value.length || Boolean(overview.value?.problem);
  /** @param {string} words @param {string} kind @param {boolean} isUsed */
  const button = (words, kind, isUsed) =>
    h(
      "button",
      {
        type: "button",
        class: kind,
        hidden: isHidden,
        "aria-disabled": isOff || undefined,
        onClick: () => isOff || store(isUsed),
      },
      words,
    );
  return h(
    Fragment,
    {},
    h("span", { class: "grow" }, !isHidden && !channels.value.length && t("import-recording-none-chosen")),
    h("a", { class: "btn", href: "#/shirt" }, t("import-recording-back")),
    button(t("import-recording-store"), "btn", false),
    button(t("import-recording-use"), "btn go", true),
  );
}
