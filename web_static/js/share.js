/**
 * The page that a share link opens: a PIN, then the story and the figures of one patient. One answer holds all of it.
 * @import { SharedView, StoryView, TaskLearning } from "types/api"
 */
import { Fragment, h as draw, render } from "./preact.js";
import { t } from "./texts.js";
import { areaCurve } from "./charts/area_curve.js";
import { day, number } from "./widgets/format.js";
import { h, put, s } from "./widgets/dom.js";
import { icon } from "./widgets/icons.js";
import { followSystem } from "./shell/theme.js";
import { comparable, measureNames, nameOf, REACHED } from "./results/measures.js";
import { Story } from "./results/story.js";
import { readReference, REFERENCE } from "./reference.js";

const HERE = "/api/v1/shared";
const main = /** @type {HTMLElement} */ (document.getElementById("main"));

const OPENED = "share opened"; // in this tab: the link whose PIN was given, so that another link asks for its own

/** The reference is read while the PIN is typed, so that the records are then one answer away. */
const firstReading = referenceIsRead();

/** Show what is shared, or ask for the PIN when it was not given here, or no longer holds. */
async function show() {
  if (sessionStorage.getItem(OPENED) !== location.hash) {
    askPin("");
    return;
  }
  const [answer, hasReference] = await Promise.all([
    fetch(HERE).catch(() => null),
    firstReading.then((isRead) => isRead || referenceIsRead()),
  ]);
  if (answer?.ok && hasReference) showShared(await answer.json());
  else askPin(answer && !answer.ok ? "" : t("share-failed"));
}

/** Read the reference; return whether the server answered. */
function referenceIsRead() {
  return readReference().then(
    () => true,
    () => false,
  );
}

/** @param {string} words of a refusal, or empty */
function askPin(words) {
  const token = location.hash.slice(1);
  if (!token) {
    put(main, h("h1", {}, t("share-heading")), h("p", { role: "alert" }, t("share-no-link")));
    return;
  }
  let isBusy = false; // a second tap would count as another try
  const pin = h("input", { type: "text", inputmode: "numeric", autocomplete: "off", maxlength: "12", required: true });
  /** @param {Event} event */
  const open = async (event) => {
    event.preventDefault();
    if (isBusy) return;
    isBusy = true;
    const body = JSON.stringify({ token, pin: pin.value.replaceAll(/\s/g, "") });
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch(`${HERE}/open`, { method: "POST", headers, body }).catch(() => null);
    if (answer?.ok) {
      sessionStorage.setItem(OPENED, location.hash);
      await show();
      return;
    }
    askPin(answer ? (await answer.json()).detail : t("share-failed"));
  };
  put(
    main,
    h(
      "section",
      {},
      h("h1", {}, t("share-heading")),
      h(
        "form",
        { onsubmit: open },
        h("label", {}, t("share-pin"), pin),
        h("p", { class: "quiet" }, t("share-pin-words")),
        h("p", { class: "problem", role: "alert" }, words),
        h("button", { class: "btn go large" }, t("share-open")),
      ),
    ),
  );
  pin.focus();
}

/** @param {SharedView} shared */
function showShared({ code, expires, stories, tasks }) {
  document.title = t("share-title", { code });
  const heading = h("h1", { tabindex: "-1" }, t("share-title", { code }));
  put(
    main,
    heading,
    h("p", { class: "quiet" }, t("share-until", { day: day(expires) })),
    tasks.map(taskCard),
    stories.map(storyCard),
  );
  heading.focus(); // the form that had the focus is gone
}

/** The button that says what this page is for, as on every other page. */
function helpButton() {
  const page = Object.assign(new EventTarget(), { route: { page: "share", rest: [] }, root: main });
  /** @type {HTMLButtonElement} */
  const button = h(
    "button",
    {
      type: "button",
      class: "btn small",
      title: t("help-open"),
      "aria-label": t("help-open"),
      "aria-expanded": "false",
      onclick: async () => (await import("./help/page_help.js")).openPageHelp(page, button),
    },
    icon("question", 22),
  );
  return button;
}

/** @param {TaskLearning} task */
function taskCard(task) {
  const words = [REACHED, ...measureNames()].filter((name) => task.words[name]);
  const areas = task.trials
    .filter((trial) => comparable("e_diff", trial))
    .map((trial) => ({ number: Number(trial.number), value: Number(trial.e_diff) }));
  return h(
    "section",
    {},
    h(
      "h2",
      {},
      t("share-task", { plan: task.floorplan_title, path: task.path_title }),
      task.source === "simulated" ? ` (${t("share-simulated")})` : "",
    ),
    h("p", {}, t("share-trajectories", { count: task.trajectories.length })),
    lines([task.path, ...task.trajectories.map(({ x, y }) => x.map((one, i) => [one, y[i]]))], "path"),
    h("p", {}, t("share-curve")),
    areaCurve(areas) ?? h("p", { class: "quiet" }, t("share-no-area")),
    areas.length > 0 &&
      h(
        "p",
        {},
        t("share-values", { first: number(areas[0].value, 2), newest: number(areas[areas.length - 1].value, 2) }),
      ),
    h("p", {}, t("share-verdicts")),
    words.length
      ? h(
          "dl",
          {},
          words.map((name) => [h("dt", {}, nameOf(name)), h("dd", {}, REFERENCE.measures.verdicts[task.words[name]])]),
        )
      : h("p", { class: "quiet" }, t("share-no-verdict")),
  );
}

/** Lines in a picture that fits them; y upwards. @param {number[][][]} all @param {string} first class of the first line */
function lines(all, first) {
  const points = all.flat();
  if (points.length === 0) return null;
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => -y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [wide, high] = [Math.max(Math.max(...xs) - left, 0.5), Math.max(Math.max(...ys) - top, 0.5)];
  const pad = 0.05 * Math.max(wide, high);
  return s(
    "svg",
    {
      viewBox: [left - pad, top - pad, wide + 2 * pad, high + 2 * pad].join(" "),
      "aria-hidden": "true",
    },
    all.map((line, i) =>
      s("polyline", { class: i === 0 ? first : "driven", points: line.map(([x, y]) => `${x},${-y}`).join(" ") }),
    ),
  );
}

/** @param {StoryView} story */
function storyCard(story) {
  const card = h("section");
  const heading = draw("h2", {}, t("share-session", { number: story.number }));
  render(draw(Fragment, {}, heading, draw(Story, { story })), card);
  return card;
}

followSystem();
main.before(h("header", {}, h("span", {}, t("app-name")), helpButton()));
show();
