/**
 * The backups that were made, whether something is wrong with them, and one now with its course.
 * @import { BackupsView, MadeBackupView } from "types/api"
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put, write } from "../../widgets/dom.js";
import { moment, size } from "../../widgets/format.js";
import { icon } from "../../widgets/icons.js";
import { rowList } from "../../widgets/list.js";

const LOOK_EVERY = 1000; // ms

/** @param {import("../../main.js").App} app @param {BackupsView} first @param {AbortSignal} signal */
export function madeCard(app, first, signal) {
  const warning = h("p", { class: "backup-warning" });
  const clock = h("p", { class: "backup-warning" });
  const last = h("p", { role: "status" });
  const title = h("h3", {}, t("backup-list"));
  const go = h("button", { type: "button", class: "btn go" }, t("backup-now"));
  const step = h("p", { class: "number", "aria-hidden": "true" });
  const bar = h("progress", { max: 1, value: 0, "aria-label": t("backup-progress") });
  const course = h(
    "div",
    { class: "measuring", hidden: true },
    step,
    bar,
    h("p", { class: "quiet small" }, t("backup-while")),
  );
  const problem = h("p", { class: "problem", role: "alert" });
  const list = rowList("made-backups");
  let timer = 0;
  let wasMaking = false;
  /** @param {BackupsView} view */
  const draw = (view) => {
    clearTimeout(timer);
    const isMaking = view.course !== null;
    put(warning, view.warning && [icon("warning", 20), h("b", {}, view.warning)]);
    put(clock, view.clock && [icon("warning", 20), h("b", {}, view.clock)]);
    if (!isMaking && wasMaking) app.toasts.show(t(view.made[0]?.good ? "backup-done" : "backup-failed"));
    write(last, view.last_good ? t("backup-last", { when: moment(view.last_good) }) : "");
    list.show(view.made.slice(0, 8).map(row));
    title.hidden = !view.made.length;
    go.disabled = isMaking || view.folder === null;
    course.hidden = !isMaking;
    if (view.course) {
      const { step: name, done, total } = view.course;
      write(step, total ? t(`backup-${name}`, { done: size(done), total: size(total) }) : t("backup-begins"));
      bar.value = total ? done / total : 0;
      if (!signal.aborted) timer = setTimeout(look, LOOK_EVERY);
    }
    wasMaking = isMaking;
  };
  const look = async () => {
    const view = await app.api.get("/backups").catch(() => null);
    if (signal.aborted) return;
    if (view) draw(view);
    else timer = setTimeout(look, LOOK_EVERY);
  };
  go.addEventListener("click", async () => {
    write(problem, "");
    try {
      draw(await app.api.post("/backups"));
    } catch (error) {
      write(problem, failureWords(error));
    }
  });
  signal.addEventListener("abort", () => clearTimeout(timer));
  draw(first);
  const element = h(
    "section",
    { class: "card stack" },
    h("h2", {}, t("backup-state-title")),
    warning,
    clock,
    last,
    h("div", {}, go),
    course,
    problem,
    title,
    list,
  );
  return { element, draw };
}

/** @param {MadeBackupView} made */
function row(made) {
  const facts = {
    files: made.files,
    size: size(made.bytes),
    encrypted: made.encrypted ? "yes" : "no",
    keys: made.with_keys ? "yes" : "no",
  };
  return h(
    "div",
    { class: "made-backup" },
    h("b", {}, moment(made.at)),
    " ",
    h("span", { class: made.good ? "tag" : "tag bad" }, t(made.good ? "backup-good" : "backup-bad")),
    h("div", { class: "quiet small" }, made.good && t("backup-of", facts)),
    made.message && h("div", { class: "small" }, made.message),
  );
}
