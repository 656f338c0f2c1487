/**
 * The page that a share link opens: a PIN, then the story and the figures of one patient. One answer holds all of it.
 * @import { SharedView, TaskLearning } from "types/api"
 */
import { focusFirst, Fragment, h, render, signal, useLayoutEffect, useRef } from "./preact.js";
import { hasText, t } from "./texts.js";
import { AreaCurve } from "./charts/area_curve.js";
import { day, number } from "./widgets/format.js";
import { Icon } from "./widgets/icons.js";
import { followSystem } from "./shell/theme.js";
import { comparable, measureNames, nameOf, REACHED } from "./results/measures.js";
import { Story } from "./results/story.js";
import { readReference, REFERENCE } from "./reference.js";

const HERE = "/api/v1/shared";
const OPENED = "share opened"; // in this tab: the link whose PIN was given, so that another link asks for its own
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
const header = document.createElement("header");

const shared = signal(/** @type {SharedView | null} */ (null)); // null: the PIN is asked for
const refusal = signal(""); // why nothing is shown

/** The reference is read while the PIN is typed, so that the records are then one answer away. */
const firstReading = referenceIsRead();

/** Read the reference; return whether the server answered. */
function referenceIsRead() {
  return readReference().then(
    () => true,
    () => false,
  );
}

/** Read what is shared; without a refusal, the PIN was not given here, or no longer holds. */
async function readShared() {
  const [answer, hasReference] = await Promise.all([
    fetch(HERE).catch(() => null),
    firstReading.then((isRead) => isRead || referenceIsRead()),
  ]);
  if (answer?.ok && hasReference) {
    /** @type {SharedView} */
    const records = await answer.json();
    document.title = t("share-title", { code: records.code });
    shared.value = records;
  } else refusal.value = answer && !answer.ok ? "" : t("share-failed");
}

/** @param {string} token of the link @param {string} pin */
async function openLink(token, pin) {
  refusal.value = "";
  const body = JSON.stringify({ token, pin });
  const headers = { "Content-Type": "application/json" };
  const answer = await fetch(`${HERE}/open`, { method: "POST", headers, body }).catch(() => null);
  if (answer?.ok) {
    sessionStorage.setItem(OPENED, location.hash);
    await readShared();
  } else refusal.value = answer ? (await answer.json()).detail : t("share-failed");
}

function Page() {
  if (shared.value) return h(Records, { records: shared.value });
  const token = location.hash.slice(1);
  if (token) return h(PinForm, { token });
  return h(Fragment, {}, h("h1", {}, t("share-heading")), h("p", { role: "alert" }, t("share-no-link")));
}

/** @param {{token: string}} form token: of the link */
function PinForm({ token }) {
  const pin = useRef(/** @type {HTMLInputElement | null} */ (null));
  const isBusy = useRef(false); // a second tap would count as another try
  useLayoutEffect(() => pin.current?.focus(), []);
  /** @param {Event} event */
  const open = async (event) => {
    event.preventDefault();
    if (isBusy.current || !pin.current) return;
    isBusy.current = true;
    await openLink(token, pin.current.value.replaceAll(/\s/g, ""));
    isBusy.current = false;
    if (shared.value || !pin.current) return;
    pin.current.value = "";
    pin.current.focus();
  };
  return h(
    "section",
    {},
    h("h1", {}, t("share-heading")),
    h(
      "form",
      { onSubmit: open },
      h(
        "label",
        {},
        t("share-pin"),
        h("input", {
          type: "text",
          inputmode: "numeric",
          autocomplete: "off",
          maxlength: 12,
          required: true,
          ref: pin,
        }),
      ),
      h("p", { class: "quiet" }, t("share-pin-words")),
      h("p", { class: "problem", role: "alert" }, refusal),
      h("button", { class: "btn go large" }, t("share-open")),
    ),
  );
}

/** @param {{records: SharedView}} page */
function Records({ records: { code, expires, stories, tasks } }) {
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1, ref: focusFirst }, t("share-title", { code })), // the form that had the focus is gone
    h("p", { class: "quiet" }, t("share-until", { day: day(expires) })),
    tasks.map((task, i) => h(TaskCard, { key: i, task })),
    stories.map((story) =>
      h(
        "section",
        { key: `session ${story.session_id}` },
        h("h2", {}, t("share-session", { number: story.number })),
        h(Story, { story }),
      ),
    ),
  );
}

/** What stands above every page; its button says what this page is for. */
function Header() {
  const page = Object.assign(new EventTarget(), { route: { page: "share", rest: [] }, root: main });
  return h(
    Fragment,
    {},
    h("span", {}, t("app-name")),
    h(
      "button",
      {
        type: "button",
        class: "btn small",
        title: t("help-open"),
        "aria-label": t("help-open"),
        "aria-expanded": "false",
        onClick: async (/** @type {Event} */ { currentTarget }) =>
          (await import("./help/page_help.js")).openPageHelp(page, /** @type {HTMLButtonElement} */ (currentTarget)),
      },
      h(Icon, { name: "question", size: 22 }),
    ),
  );
}

/** @param {{task: TaskLearning}} card */
function TaskCard({ task }) {
  const words = [REACHED, ...measureNames()].filter((name) => task.words[name]);
  const areas = task.trials
    .filter((trial) => comparable("e_diff", trial))
    .map((trial) => ({ number: Number(trial.number), value: Number(trial.e_diff) }));
  const trajectories = task.trajectories.map(({ x, y }) => x.map((one, i) => [one, y[i]]));
  return h(
    "section",
    {},
    h(
      "h2",
      {},
      t("share-task", { plan: task.floorplan_title, path: task.path_title }),
      hasText(`share-source-${task.source}`) && ` (${t(`share-source-${task.source}`)})`,
    ),
    h("p", {}, t("share-trajectories", { count: task.trajectories.length })),
    h(Lines, { all: [task.path, ...trajectories] }),
    h("p", {}, t("share-curve")),
    areas.length > 0 ? h(AreaCurve, { trials: areas }) : h("p", { class: "quiet" }, t("share-no-area")),
    areas.length > 0 &&
      h(
        "p",
        {},
        t("share-values", { first: number(areas[0].value, 2), newest: number(areas[areas.length - 1].value, 2) }),
      ),
    h("p", {}, t("share-verdicts")),
    words.length > 0
      ? h(
          "dl",
          {},
          words.map((name) =>
            h(
              Fragment,
              { key: name },
              h("dt", {}, nameOf(name)),
              h("dd", {}, REFERENCE.measures.verdicts[task.words[name]]),
            ),
          ),
        )
      : h("p", { class: "quiet" }, t("share-no-verdict")),
  );
}

/** Lines in a picture that fits them, the first one that of the path; y upwards. @param {{all: number[][][]}} lines */
function Lines({ all }) {
  const points = all.flat();
  if (points.length === 0) return null;
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => -y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [wide, high] = [Math.max(Math.max(...xs) - left, 0.5), Math.max(Math.max(...ys) - top, 0.5)];
  const pad = 0.05 * Math.max(wide, high);
  return h(
    "svg",
    { viewBox: [left - pad, top - pad, wide + 2 * pad, high + 2 * pad].join(" "), "aria-hidden": "true" },
    all.map((line, i) =>
      h("polyline", {
        key: i,
        class: i === 0 ? "path" : "driven",
        points: line.map(([x, y]) => `${x},${-y}`).join(" "),
      }),
    ),
  );
}

followSystem();
main.before(header);
render(h(Header, {}), header);
if (sessionStorage.getItem(OPENED) === location.hash) await readShared();
main.replaceChildren(); // that the page is starting
render(h(Page, {}), main);
