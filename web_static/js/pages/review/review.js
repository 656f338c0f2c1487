/**
 * Review: how a measure went over trials, all trajectories over the path, and every trial.
 * @import { Learning } from "types/documents"
 * @import { SourceGroup } from "../../results/source_group.js"
 */
import { failureWords } from "../../api.js";
import { compareChoice } from "./compare_choice.js";
import { curveCard } from "./curve_card.js";
import { followTrials } from "./follow_trials.js";
import { h, put } from "../../widgets/dom.js";
import { firstPath, inOrder, keyOf, pathsOf, pathWords } from "./path_choice.js";
import { field, selection } from "../../widgets/fields.js";
import { entryOf, measured, measureNames, leadingMeasures, nameOf } from "../../results/measures.js";
import { emptyPage } from "../../shell/nobody.js";
import { firstGroup, groupChoice, groupMark } from "../../results/source_group.js";
import { testsPlace } from "../../interface_test/interface_tests.js";
import { reportCard } from "../../results/report_choice.js";
import { qualitySection } from "./quality_section.js";
import { sessionVerdicts } from "./session_verdicts.js";
import { trajectoriesChart } from "../../charts/trajectories_chart.js";
import { trialList } from "./trial_list.js";
import { t } from "../../texts.js";
import { unreadMarks } from "../../results/unread_marks.js";

const MEASURE_PLACE = "bodydrive-measure";
const WIDE = 24; // trials: more have the whole width
export const OWN_PAGES = ["trial", "compare"]; // #/review/PATIENT/trial/ID, #/review/PATIENT/compare/ID/ID

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  if (OWN_PAGES.includes(rest[1])) return (await import(`./${rest[1]}.js`)).show(app, root, { signal, rest });
  const patients = await app.api.get("/patients");
  const patient =
    patients.find(({ id }) => String(id) === rest[0]) ??
    patients.find(({ id }) => id === app.session?.patient?.id) ??
    patients.find(({ trials }) => trials) ??
    patients[0];
  if (signal.aborted) return;
  if (!patient) return emptyPage(root, t("review-none-title"), t("review-nobody-lead"), "#/patients", t("nobody-go"));
  let trials = await app.api.get(`/trials?patient=${patient.id}`);
  if (signal.aborted) return;
  app.setSubject({ code: patient.code, sessions: [] });
  let redraw = () => app.show();
  followTrials(app, patient.id, trials, (now) => ((trials = now), redraw()), signal);
  const who = field(
    t("review-patient"),
    selection(
      patients.map(({ id, code, pseudonym }) => ({ value: String(id), label: `${code} ${pseudonym}` })),
      String(patient.id),
      (id) => app.go(`#/review/${id}`),
    ),
  );
  if (!trials.length) return noTrials(app, root, patients.length > 1 ? who : null, testsPlace(app, patient.id, signal));
  const [plans, unread] = await Promise.all([app.api.get("/floorplans"), unreadMarks(app, patient.id, signal)]);
  if (signal.aborted) return;
  const paths = pathsOf(trials);
  let path =
    paths.find(({ key }) => key === decodeURIComponent(rest.slice(1, 3).join("/"))) ?? firstPath(paths, trials);
  /** @param {number} trial id */
  const opens = (trial) => app.go(`#/review/${patient.id}/trial/${trial}`);
  let measure = sessionStorage.getItem(MEASURE_PLACE) ?? "e_diff";
  const place = h("div", { class: "stack" });
  const pathPlace = h("div", { class: "path-place" });
  const measurePlace = h("div", {});
  const groupPlace = h("div", {});
  const testPlace = testsPlace(app, patient.id, signal);
  /** @type {SourceGroup} */
  let group = firstGroup(trials);
  let compare = compareChoice(patient.id);
  let drawn = new AbortController();
  const draw = async () => {
    drawn.abort();
    const until = (drawn = new AbortController()).signal;
    signal.addEventListener("abort", () => drawn.abort(), { signal: until });
    choosePath();
    chooseMeasure();
    const where = `floorplan=${encodeURIComponent(path.floorplan)}&path=${encodeURIComponent(path.name)}&source=${group}`;
    const ofMeasure = entryOf(measure) ? `&measure=${measure}` : "";
    chooseGroup();
    const known = plans.some(({ name }) => name === path.floorplan);
    const [answer, plan] = await Promise.all([
      app.api.get(`/patients/${patient.id}/learning?${where}${ofMeasure}`),
      known ? app.api.get(`/floorplans/${path.floorplan}`) : null,
    ]);
    if (until.aborted) return;
    const learning = /** @type {Learning} */ (answer);
    const curve = await curveCard(learning, measure, opens, until);
    if (until.aborted) return;
    const counts = learning.trials.length > 0;
    const quality = h("div", {});
    const trajectories = h("div", { class: "chart" });
    /** @param {unknown} error */
    const fail = (error) => until.aborted || app.toasts.show(failureWords(error));
    // The server may have to read old recordings for these, so the curve is drawn first.
    if (counts) {
      const made = app.api.get(`/patients/${patient.id}/trajectories?${where}`);
      made.then((lines) => trajectoriesChart(lines, plan, until)).then((one) => trajectories.replaceWith(one), fail);
      qualitySection(app, patient, where, until).then((one) => put(quality, one), fail);
    }
    put(
      place,
      counts && sessionVerdicts(learning, measure, patient),
      counts &&
        h(
          "div",
          { class: learning.trials.length > WIDE ? "charts wide" : "charts" },
          curve,
          h(
            "section",
            { class: "card" },
            h("h2", {}, t("review-trajectories"), " ", groupMark(learning.source)),
            trajectories,
          ),
        ),
      !counts &&
        h(
          "p",
          { class: "card quiet" },
          t(Object.keys(learning.others).length ? "review-other-source" : "review-no-kept"),
        ),
      quality,
      trialList(
        patient,
        trials.filter((trial) => keyOf(trial) === path.key),
        new Set(learning.trials.filter(({ familiarisation }) => familiarisation).map(({ id }) => id)),
        compare,
        unread,
      ),
      testPlace,
      reportCard(app, patient),
    );
  };
  /** Draw what somebody has chosen: until it has come, nothing of the choice before is shown. */
  const drawChoice = async () => {
    put(place, h("p", { class: "quiet", role: "status" }, t("loading")));
    await draw().catch((error) => {
      put(place);
      throw error;
    });
  };
  let offered = "";
  /** Offer the paths of the trials; a choice that somebody has open stays while it is the same. */
  const choosePath = () => {
    const paths = pathsOf(trials);
    const choices = inOrder(paths, plans).map((one) => ({ value: one.key, ...pathWords(one, plans) }));
    if (offered === JSON.stringify(choices)) return;
    offered = JSON.stringify(choices);
    const choice = selection(choices, path.key, (key) => {
      path = paths.find((one) => one.key === key) ?? path;
      compare = compareChoice(patient.id);
      app.toasts.attempt(drawChoice);
    });
    put(pathPlace, field(t("review-path"), choice));
  };
  const chooseGroup = () => {
    const choice = groupChoice(
      trials.filter((trial) => keyOf(trial) === path.key),
      group,
      (chosen) => {
        group = chosen;
        app.toasts.attempt(drawChoice);
      },
    );
    put(groupPlace, choice);
  };
  /** Offer the measures that the task has: a turn on the spot has no distance driven. */
  const chooseMeasure = () => {
    const all = trials.flatMap(({ measures, ...trial }) => (measures && keyOf(trial) === path.key ? [measures] : []));
    const names = measureNames().filter((name) => all.some((measures) => measured(measures, name) !== null));
    if (!names.length) names.push(measure);
    if (!names.includes(measure))
      measure = leadingMeasures(all[all.length - 1]).find((name) => names.includes(name)) ?? names[0];
    const choice = selection(
      names.map((name) => ({ value: name, label: nameOf(name) })),
      measure,
      (name) => {
        measure = name;
        sessionStorage.setItem(MEASURE_PLACE, name);
        app.toasts.attempt(drawChoice);
      },
    );
    put(measurePlace, field(t("review-measure"), choice));
  };
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("review-title")),
      h(
        "div",
        { class: "columns filters" },
        patients.length > 1 && who,
        h("a", { class: "btn", href: `#/session/patient/${patient.id}` }, t("record-link")),
        patients.length > 1 && h("a", { class: "btn", href: "#/attention" }, t("attention-open")),
        pathPlace,
        measurePlace,
        groupPlace,
      ),
      place,
    ),
  );
  redraw = async () => void (await app.toasts.attempt(draw));
  await drawChoice();
}

/**
 * @param {import("../../main.js").App} app @param {HTMLElement} root @param {Node | null} who to choose another patient by
 * @param {Node} tests before driving, which there may be without a trial
 */
function noTrials(app, root, who, tests) {
  const action = app.me?.role === "reviewer" ? undefined : t("review-none-go"); // a reviewer starts no trial
  emptyPage(root, t("review-none-title"), t("review-none-lead"), "#/drive", action);
  if (who) root.firstElementChild?.append(h("div", { class: "other-patient" }, who));
  root.firstElementChild?.append(tests);
}
