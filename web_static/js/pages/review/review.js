/**
 * Review: how a measure went over trials, all trajectories over the path, and every trial.
 * @import { App } from "../../main.js"
 * @import { InterfaceTestsView, PatientView } from "types/api"
 * @import { ReadonlySignal } from "../../preact.js"
 * @import { PathReview, ReviewStore } from "./store.js"
 * @typedef {ReadonlySignal<InterfaceTestsView | null>} Tests before driving, which there may be without a trial
 */
import { ChartPlace } from "../../charts/chart_place.js";
import { trajectoriesChart } from "../../charts/trajectories_chart.js";
import { PatientTests, patientTests } from "../../interface_test/interface_tests.js";
import { newestAnswer } from "../../live/newest_answer.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { nameOf } from "../../results/measures.js";
import { ReportCard } from "../../results/report_choice.js";
import { GroupChoice, GroupMark } from "../../results/source_group.js";
import { unreadComments } from "../../results/unread_marks.js";
import { emptyPage } from "../../shell/nobody.js";
import { t } from "../../texts.js";
import { Field, Selection } from "../../widgets/fields.js";
import { CurveCard } from "./curve_card.js";
import { inOrder, pathWords } from "./path_choice.js";
import { QualitySection } from "./quality_section.js";
import { SessionVerdictsCard } from "./session_verdicts.js";
import { followTrials, reviewStore } from "./store.js";
import { TrialList } from "./trial_list.js";

const WIDE = 24; // trials: more have the whole width
export const OWN_PAGES = ["trial", "compare"]; // #/review/PATIENT/trial/ID, #/review/PATIENT/compare/ID/ID

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal: left, rest }) {
  if (OWN_PAGES.includes(rest[1])) return (await import(`./${rest[1]}.js`)).show(app, root, { signal: left, rest });
  const all = await app.api.get("/patients");
  const patient =
    all.find(({ id }) => String(id) === rest[0]) ??
    all.find(({ id }) => id === app.session?.patient?.id) ??
    all.find(({ trials }) => trials) ??
    all[0];
  if (left.aborted) return;
  if (!patient) return emptyPage(root, t("review-none-title"), t("review-nobody-lead"), "#/patients", t("nobody-go"));
  const [first, plans, unread] = await Promise.all([
    app.api.get(`/trials?patient=${patient.id}`),
    app.api.get("/floorplans"),
    unreadComments(app, patient.id, left),
  ]);
  if (left.aborted) return;
  app.setSubject({ patient: patient.id, code: patient.code, sessions: [] });
  const patients = newestAnswer(app, left, all, () => app.api.get("/patients"), { what: ["deletion", "restoration"] });
  const tests = patientTests(app, patient.id, left); // read once, also when another path is chosen
  if (!first.length) {
    followTrials(app, patient.id, first, left, () => app.show());
    return drawPage(root, h(NoTrials, { app, left, patients, patient, tests }), "body empty");
  }
  const named = decodeURIComponent(rest.slice(1, 3).join("/"));
  const store = reviewStore(app, { patients, patient, first, plans, unread }, named, left);
  drawPage(root, h(Page, { store, tests }));
  await store.read();
}

/** @param {{app: App, patients: ReadonlySignal<PatientView[]>, patient: PatientView}} choice */
function PatientChoice({ app, patients, patient }) {
  const choice = h(Selection, {
    options: patients.value.map(({ id, code, pseudonym }) => ({ value: String(id), label: `${code} ${pseudonym}` })),
    chosen: String(patient.id),
    onChange: (id) => app.go(`#/review/${id}`),
  });
  return h(Field, { label: t("review-patient") }, choice);
}

/**
 * @param {{app: App, left: AbortSignal, patients: ReadonlySignal<PatientView[]>, patient: PatientView,
 *   tests: Tests}} page
 */
function NoTrials({ app, left, patients, patient, tests }) {
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("review-none-title")),
    h("p", { class: "lead" }, t("review-none-lead")),
    app.me?.role !== "reviewer" && h("a", { class: "btn go large", href: "#/drive" }, t("review-none-go")),
    patients.value.length > 1 && h("div", { class: "other-patient" }, h(PatientChoice, { app, patients, patient })),
    h(PatientTests, { app, left, tests }),
  );
}

/** @param {{store: ReviewStore, tests: Tests}} page */
function Page({ store, tests }) {
  const { app, left, patients, patient } = store;
  const review = store.review.value;
  const read = review === "reading" ? null : review;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("review-title")),
    h(
      "div",
      { class: "columns filters" },
      patients.value.length > 1 && h(PatientChoice, { app, patients, patient }),
      h("a", { class: "btn", href: `#/session/patient/${patient.id}` }, t("record-link")),
      patients.value.length > 1 && h("a", { class: "btn", href: "#/attention" }, t("attention-open")),
      h(Choices, { store }),
    ),
    h(
      "div",
      { class: "stack" },
      review === "reading" && h("p", { class: "quiet", role: "status" }, t("loading")),
      read && [
        h(PathResults, { key: "results", store, review: read }),
        h(TrialList, { key: "trials", store, learning: read.learning }),
      ],
      h(PatientTests, { app, left, tests, isHidden: !read }), // what was opened on it stays open
      read && h(ReportCard, { app, patient }),
    ),
  );
}

/** Path, measure and source. @param {{store: ReviewStore}} choices */
function Choices({ store }) {
  const { plans, paths, path, trialsOfPath, measures, measure, group } = store;
  const pathChoice = h(Selection, {
    options: inOrder(paths.value, plans).map((one) => ({ value: one.key, ...pathWords(one, plans) })),
    chosen: path.value.key,
    onChange: store.choosePath,
  });
  const measureChoice = h(Selection, {
    options: measures.value.map((name) => ({ value: name, label: nameOf(name) })),
    chosen: measure.value,
    onChange: store.chooseMeasure,
  });
  const groupChoice = { trials: trialsOfPath.value, chosen: group.value, onChange: store.chooseGroup };
  return h(
    Fragment,
    {},
    h("div", { class: "path-place" }, h(Field, { label: t("review-path") }, pathChoice)),
    h("div", {}, h(Field, { label: t("review-measure") }, measureChoice)),
    h("div", {}, h(GroupChoice, groupChoice)),
  );
}

/**
 * What was learnt on the path, or that no trial on it counts.
 * @param {{store: ReviewStore, review: PathReview}} results
 */
function PathResults({ store, review }) {
  const { app, left, patient, trajectories, quality } = store;
  const { learning, measure, plan } = review;
  if (!learning.trials.length) {
    const key = Object.keys(learning.others).length ? "review-other-source" : "review-no-kept";
    return h("p", { class: "card quiet" }, t(key));
  }
  const driven = trajectories.value;
  const trajectoriesPlace = driven
    ? h(ChartPlace, { app, left, of: [driven], make: (until) => trajectoriesChart(driven, plan, until) })
    : h("div", { class: "chart" });
  return h(
    Fragment,
    {},
    h(SessionVerdictsCard, { learning, measure, patient }),
    h(
      "div",
      { class: learning.trials.length > WIDE ? "charts wide" : "charts" },
      h(CurveCard, { app, left, patient, review }),
      h(
        "section",
        { class: "card" },
        h("h2", {}, t("review-trajectories"), " ", h(GroupMark, { group: learning.source })),
        trajectoriesPlace,
      ),
    ),
    quality.value && h(QualitySection, { app, left, view: quality.value }),
  );
}
