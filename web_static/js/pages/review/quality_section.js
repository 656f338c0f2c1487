/** The quality of control over trials: a figure to choose, for all joints or one, and what to look at. */
import { t } from "../../texts.js";
import { controlWarnings } from "../../results/control_warnings.js";
import { h, put } from "../../widgets/dom.js";
import { field, selection } from "../../widgets/fields.js";
import { jointLabel } from "../../widgets/joint_words.js";
import { qualityChart } from "../../charts/quality_chart.js";
import { groupMark } from "../../results/source_group.js";
import { OF_JOINT } from "../../results/quality_card.js";

/** @type {string[]} */
const OF_ALL = ["map_angle_deg", "evr", "null_space_share", "cross_talk", "activations_per_metre", "activations"];
const ALL = "";

/**
 * @param {import("../../main.js").App} app @param {{id: number}} patient
 * @param {string} where the query that names floor plan and path @param {AbortSignal} signal
 * @returns {Promise<HTMLElement>}
 */
export async function qualitySection(app, patient, where, signal) {
  const found = await app.api.get(`/patients/${patient.id}/quality?${where}`);
  const place = h("div", {});
  const fields = h("div", { class: "columns filters" });
  let joint = ALL;
  let name = "map_angle_deg";
  let drawn = new AbortController();
  const draw = async () => {
    drawn.abort();
    const until = (drawn = new AbortController()).signal;
    signal.addEventListener("abort", () => drawn.abort(), { signal: until });
    const picture = await qualityChart(found.trials, name, joint, until);
    if (!until.aborted) put(place, picture);
  };
  const redraw = () => app.toasts.attempt(draw);
  const choose = () => {
    /** @type {readonly string[]} */
    const names = joint === ALL ? OF_ALL : OF_JOINT;
    if (!names.includes(name)) name = names[0];
    put(
      fields,
      field(
        t("quality-choose"),
        selection(
          names.map((value) => ({ value, label: t(`quality-${value}`) })),
          name,
          (value) => {
            name = value;
            redraw();
          },
        ),
      ),
      field(
        t("quality-choose-joint"),
        selection(
          [
            { value: ALL, label: t("quality-all-joints") },
            ...Object.entries(found.labels).map(([name, label]) => ({
              value: name,
              label: jointLabel({ name, label }),
            })),
          ],
          joint,
          (value) => {
            joint = value;
            choose();
            redraw();
          },
        ),
      ),
    );
  };
  if (found.trials.length) {
    choose();
    await draw();
  }
  return h(
    "div",
    { class: "stack" },
    controlWarnings(found.warnings, app.me?.role !== "reviewer"),
    h(
      "section",
      { class: "card" },
      h("h2", {}, t("quality-over"), " ", groupMark(found.source)),
      found.trials.length ? [fields, place] : h("p", { class: "quiet" }, t("quality-empty")),
      found.note && h("p", { class: "quiet small" }, found.note),
    ),
  );
}
