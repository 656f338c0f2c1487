/** Review: how a measure went over trials, all trajectories over the path, and every trial. */
import { compareChoice } from "../parts/compare_choice.js";
import { h, put } from "../parts/dom.js";
import { field, selection } from "../parts/fields.js";
import { moment } from "../parts/format.js";
import { curveChart, trajectoriesChart } from "../parts/learning_charts.js";
import { MEASURES, mostTelling, withUnit } from "../parts/measures.js";
import { emptyPage } from "../parts/nobody.js";
import { qualitySection } from "../parts/quality_section.js";
import { t } from "../texts.js";

const MEASURE_PLACE = "bodydrive-measure";
const OWN_PAGES = ["trial", "compare"]; // #/review/PATIENT/trial/ID, #/review/PATIENT/compare/ID/ID

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal, rest: string[]}} page */
export async function show(app, root, { signal, rest }) {
  if (OWN_PAGES.includes(rest[1])) return (await import(`./${rest[1]}.js`)).show(app, root, { signal, rest });
  const patients = await app.api.get("/patients");
  const patient =
    patients.find(({ id }) => String(id) === rest[0]) ??
    patients.find(({ id }) => id === app.visit?.patient?.id) ??
    patients.find(({ trials }) => trials) ??
    patients[0];
  if (signal.aborted) return;
  if (!patient) return emptyPage(root, t("review.none.title"), t("review.nobody.lead"), "#/patients", t("nobody.go"));
  const trials = await app.api.get(`/trials?patient=${patient.id}`);
  if (signal.aborted) return;
  const who = field(
    t("review.patient"),
    selection(
      patients.map(({ id, code, pseudonym }) => ({ value: String(id), label: `${code} ${pseudonym}` })),
      String(patient.id),
      (id) => app.go(`#/review/${id}`),
    ),
  );
  if (!trials.length) return noTrials(root, patients.length > 1 ? who : null);
  const [plans, paths] = [await app.api.get("/floorplans"), driven(trials)];
  if (signal.aborted) return;
  let path = paths.find(({ key }) => key === decodeURIComponent(rest.slice(1, 3).join("/"))) ?? paths.at(-1);
  let measure = sessionStorage.getItem(MEASURE_PLACE) ?? "e_diff";
  const place = h("div", { class: "stack" });
  const measurePlace = h("div", {});
  let drawn = new AbortController();
  const draw = async () => {
    drawn.abort();
    const until = (drawn = new AbortController()).signal;
    signal.addEventListener("abort", () => drawn.abort(), { signal: until });
    chooseMeasure();
    const where = `floorplan=${encodeURIComponent(path.floorplan)}&path=${encodeURIComponent(path.name)}`;
    const known = plans.some(({ name }) => name === path.floorplan);
    const [learning, plan] = await Promise.all([
      app.api.get(`/patients/${patient.id}/learning?${where}`),
      known ? app.api.get(`/floorplans/${path.floorplan}`) : null,
    ]);
    if (until.aborted) return;
    const charts = await Promise.all([curveChart(learning, measure, until), trajectoriesChart(learning, plan, until)]);
    const counts = learning.trials.length > 0;
    const quality = counts && (await qualitySection(app, patient, where, until));
    if (until.aborted) return;
    put(
      place,
      counts &&
        h(
          "div",
          { class: "charts" },
          h(
            "section",
            { class: "card" },
            h("h2", {}, t("review.curve")),
            charts[0],
            h("p", { class: "small" }, learning.curves[measure]?.text ?? ""),
          ),
          h("section", { class: "card" }, h("h2", {}, t("review.trajectories")), charts[1]),
        ),
      !counts && h("p", { class: "card quiet" }, t("review.no-kept")),
      quality,
      trialList(
        patient,
        trials.filter((trial) => keyOf(trial) === path.key),
      ),
    );
  };
  const choosePath = selection(
    inOrder(paths, plans).map((one) => ({ value: one.key, ...pathWords(one, plans) })),
    path.key,
    (key) => {
      path = paths.find((one) => one.key === key);
      draw().catch((error) => app.toasts.show(error.message));
    },
  );
  /** Only what the task has: a turn on the spot has no distance driven. */
  const chooseMeasure = () => {
    const measured = trials.filter((trial) => keyOf(trial) === path.key && trial.measures).map(({ measures }) => measures);
    const names = Object.keys(MEASURES).filter((name) => measured.some((measures) => Number.isFinite(measures[name])));
    if (!names.length) names.push(measure);
    if (!names.includes(measure)) measure = mostTelling(measured.at(-1)).find((name) => names.includes(name)) ?? names[0];
    const choice = selection(
      names.map((name) => ({ value: name, label: t(`measure.${name}`) })),
      measure,
      (name) => {
        measure = name;
        sessionStorage.setItem(MEASURE_PLACE, name);
        draw().catch((error) => app.toasts.show(error.message));
      },
    );
    put(measurePlace, field(t("review.measure"), choice));
  };
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("review.title")),
      h(
        "div",
        { class: "columns filters" },
        patients.length > 1 && who,
        field(t("review.path"), choosePath),
        measurePlace,
      ),
      place,
    ),
  );
  await draw();
}

function keyOf({ floorplan, path }) {
  return `${floorplan}/${path}`;
}

/** The paths that were driven, the last driven last. */
function driven(trials) {
  const found = new Map();
  for (const trial of trials) {
    found.delete(keyOf(trial));
    found.set(keyOf(trial), {
      key: keyOf(trial),
      floorplan: trial.floorplan,
      name: trial.path,
      title: trial.floorplan_title,
    });
  }
  return [...found.values()];
}

/** By place and level as on the Drive page, then by task; what is not there any more last. */
function inOrder(paths, plans) {
  const rank = ({ floorplan, name }) => {
    const at = plans.findIndex((plan) => plan.name === floorplan);
    return at < 0 ? Infinity : at + plans[at].paths.findIndex((one) => one.name === name) / 100;
  };
  return paths.toSorted((a, b) => (rank(a) === rank(b) ? 0 : rank(a) - rank(b)));
}

/** Where it is, how difficult, and the task; the levels of one scene stand together. */
function pathWords({ floorplan, name, title }, plans) {
  const plan = plans.find((one) => one.name === floorplan);
  const task = plan?.paths.find((one) => one.name === name)?.title ?? name;
  return { label: `${title}: ${task}`, group: plan?.scene?.title ?? title };
}

function noTrials(root, who) {
  emptyPage(root, t("review.none.title"), t("review.none.lead"), "#/drive", t("review.none.go"));
  if (who) root.firstElementChild.append(h("div", { class: "other-patient" }, who));
}

function trialList(patient, trials) {
  const listed = mostTelling(trials.findLast(({ measures }) => measures)?.measures ?? {});
  const compare = compareChoice(patient.id);
  const row = (trial) =>
    h(
      "tr",
      { class: trial.kept ? null : "discarded" },
      h(
        "th",
        { scope: "row" },
        h(
          "a",
          {
            class: "row-link",
            href: `#/review/${patient.id}/trial/${trial.id}`,
            "aria-label": t("review.open", { number: trial.number }),
          },
          String(trial.number),
        ),
      ),
      h("td", {}, moment(trial.started)),
      h("td", {}, t(`review.end.${trial.end}`)),
      listed.map((name) => h("td", {}, trial.measures ? withUnit(name, trial.measures[name]) : "–")),
      h("td", {}, trial.kept ? t("review.kept") : trial.discard_reason),
      h("td", {}, compare.box(trial)),
    );
  const head = [
    t("review.column.number"),
    t("review.column.when"),
    t("review.column.end"),
    ...listed.map((name) => t(`measure.${name}`)),
    t("review.column.kept"),
    t("compare.column"),
  ];
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("review.trials")),
    h(
      "div",
      { class: "scroll-x", tabindex: "0", role: "region", "aria-label": t("review.trials") },
      h(
        "table",
        { class: "measures trials" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            head.map((words) => h("th", { scope: "col" }, words)),
          ),
        ),
        h("tbody", {}, trials.toReversed().map(row)),
      ),
    ),
    trials.length > 1 && compare.element,
  );
}
