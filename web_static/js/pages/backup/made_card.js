/**
 * The backups that were made, whether something is wrong with them, and one now with its course.
 * @import { BackupsView, MadeBackupView } from "types/api"
 */
import { Fragment, h, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { moment, size } from "../../widgets/format.js";
import { Icon } from "../../widgets/icons.js";

const MOST_ROWS = 8;

/** @param {{store: import("./store.js").BackupStore}} card */
export function MadeCard({ store: { app, view, change } }) {
  const { warning, clock, last_good: last, folder, course, made } = view.value;
  const problem = useSignal("");
  const isOff = course !== null || folder === null;
  const backUp = async () => {
    if (isOff) return;
    problem.value = "";
    problem.value = await change(() => app.api.post("/backups"));
  };
  return h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("backup-state-title")),
    warningLine(warning),
    warningLine(clock),
    h("p", { role: "status" }, last && t("backup-last", { when: moment(last) })),
    h(
      "div",
      {},
      h(
        "button",
        { type: "button", class: "btn go", "aria-disabled": isOff || undefined, onClick: backUp },
        t("backup-now"),
      ),
    ),
    h(
      "div",
      { class: "measuring", hidden: !course },
      h("p", { class: "number", "aria-hidden": "true" }, course && courseWords(course)),
      h("progress", {
        max: 1,
        value: course?.total ? course.done / course.total : 0,
        "aria-label": t("backup-progress"),
      }),
      h("p", { class: "quiet small" }, t("backup-while")),
    ),
    h("p", { class: "problem", role: "alert" }, problem),
    h("h3", { hidden: !made.length }, t("backup-list")),
    h(
      "div",
      { class: "made-backups", role: made.length ? "list" : undefined },
      made.slice(0, MOST_ROWS).map((one) => h(Row, { key: `${one.at} ${one.place} ${one.name}`, made: one })),
    ),
  );
}

/** @param {string} words */
const warningLine = (words) =>
  h(
    "p",
    { class: "backup-warning" },
    words && h(Fragment, {}, h(Icon, { name: "warning", size: 20 }), h("b", {}, words)),
  );

/** @param {NonNullable<BackupsView["course"]>} course */
function courseWords({ step, done, total }) {
  return total ? t(`backup-${step}`, { done: size(done), total: size(total) }) : t("backup-begins");
}

/** @param {{made: MadeBackupView}} row */
function Row({ made }) {
  const facts = {
    files: made.files,
    size: size(made.bytes),
    encrypted: made.encrypted ? "yes" : "no",
    keys: made.with_keys ? "yes" : "no",
  };
  return h(
    "div",
    { class: "made-backup", role: "listitem" },
    h("b", {}, moment(made.at)),
    " ",
    h("span", { class: made.good ? "tag" : "tag bad" }, t(made.good ? "backup-good" : "backup-bad")),
    h("div", { class: "quiet small" }, made.good && t("backup-of", facts)),
    made.message && h("div", { class: "small" }, made.message),
  );
}
