/** The columns of the file: which of them are channels, and of which joint each is. */
import { h } from "../../preact.js";
import { t } from "../../texts.js";
import { Selection, Toggle } from "../../widgets/fields.js";
import { percent, significant } from "../../widgets/format.js";
import { jointLabel } from "../../widgets/joint_words.js";
import { ScrollTable, TableHead } from "../../widgets/scroll_table.js";

const DIGITS = 4; // that count, of a range

/**
 * @typedef {import("./store.js").ImportStore} ImportStore
 * @typedef {import("types/api").RecordingOverview} RecordingOverview
 * @param {{store: ImportStore, overview: RecordingOverview}} card
 */
export function ChannelsCard({ store, overview: { columns, joints } }) {
  const { channels, setChannel, setJoint } = store;
  const chosen = new Map(channels.value.map(({ column, joint }) => [column, joint]));
  const possible = columns.filter(({ joint }) => joint !== null);
  const options = joints.map((joint) => ({ value: joint.name, label: jointLabel(joint) }));
  const titles = ["channel", "unit", "range", "missing", "joint"];
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("import-recording-channels")),
    h(
      "details",
      {},
      h("summary", {}, t("import-recording-channels-count", { count: chosen.size, all: possible.length })),
      h(
        ScrollTable,
        { label: t("import-recording-channels"), kind: "import-columns" },
        h(TableHead, { columns: titles.map((title) => t(`import-recording-title-${title}`)) }),
        h(
          "tbody",
          {},
          possible.map(({ name, unit, least, most, missing }) =>
            h(
              "tr",
              { key: name },
              h("td", {}, h(Toggle, { label: name, on: chosen.has(name), onChange: (isIn) => setChannel(name, isIn) })),
              h("td", {}, unit),
              h("td", { class: "number" }, rangeWords(least, most)),
              h("td", { class: "number" }, percent(missing)),
              h(
                "td",
                {},
                chosen.has(name) &&
                  h(Selection, {
                    "aria-label": t("import-recording-joint-of", { name }),
                    options,
                    chosen: chosen.get(name) ?? null,
                    onChange: (joint) => setJoint(name, joint),
                  }),
              ),
            ),
          ),
        ),
      ),
    ),
  );
}

/** @param {number | null} least @param {number | null} most */
function rangeWords(least, most) {
  if (least === null || most === null) return "";
  return t("import-recording-range", { least: significant(least, DIGITS), most: significant(most, DIGITS) });
}
