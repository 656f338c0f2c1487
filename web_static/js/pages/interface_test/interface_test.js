/**
 * The two-minute test before driving: targets on a cross, reached with a dot, while no chair moves.
 * @import { App } from "../../main.js"
 * @import { InterfaceTestsView } from "types/api"
 */
import { h, put, write } from "../../widgets/dom.js";
import { clock } from "../../widgets/format.js";
import { pads } from "../../widgets/pads.js";
import { targetCross } from "../../interface_test/target_cross.js";
import { courseCard, newestTest, testFigures } from "../../interface_test/interface_tests.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { t } from "../../texts.js";
import { workloadCard } from "./workload_card.js";

const CONCERNS = ["test", "everything"];

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile)
    return emptyPage(root, t("drive-none-title"), t("drive-none-lead"), "#/calibrate", t("drive-none-go"));
  const mayTest = app.me?.role !== "reviewer";
  const path = /** @type {const} */ (`/interface-tests?patient=${here.patient.id}`);
  const [read, equipment] = await Promise.all([app.api.get(path), app.api.get("/equipment")]);
  if (signal.aborted) return;
  const isVisitor = equipment.shirt?.kind === "simulator" && equipment.body?.kind === "visitor";
  const stage = stageOf(app, mayTest, (is) => root.classList.toggle("test-runs", is), signal);
  const results = h("div", { class: "stack test-results" });
  let drawn = new AbortController();
  signal.addEventListener("abort", () => drawn.abort());
  /** @param {InterfaceTestsView} now */
  const draw = (now) => {
    drawn.abort();
    drawn = new AbortController();
    const test = newestTest(now);
    stage.setRunning(now.tests.some(({ status }) => status === "running"));
    stage.element.classList.toggle("rests", test !== null); // the figures stand in its place
    put(
      results,
      test && testFigures(test),
      test &&
        mayTest &&
        test.end === "complete" &&
        test.session_id === app.session?.session?.id &&
        workloadCard(app, test),
      test && courseCard(now, drawn.signal),
    );
  };
  let shown = stamp(read);
  const again = async () => {
    const now = await app.api.get(path).catch(() => null);
    if (signal.aborted || !now || stamp(now) === shown) return;
    shown = stamp(now);
    draw(now);
  };
  app.live.addEventListener("changed", ({ detail }) => CONCERNS.includes(detail) && again(), { signal });
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("rail-interface-test")),
      h("p", { class: "lead" }, t("test-lead")),
      h(
        "div",
        { class: "stack" },
        stage.element,
        isVisitor && h("div", { class: "card pad-card" }, pads(app, signal).element),
        results,
      ),
    ),
    h("div", { class: "foot" }, h("span", { class: "grow" }), stage.buttons),
  );
  draw(read);
}

/** What of the tests makes the page new: not the answers about workload, which are given on it. @param {InterfaceTestsView} read */
function stamp({ tests }) {
  return JSON.stringify(tests.map(({ id, status, end }) => [id, status, end]));
}

/**
 * The cross with what it says, and the buttons.
 * @param {App} app @param {boolean} mayTest @param {(is: boolean) => void} onRunning told whether a test runs
 * @param {AbortSignal} signal
 */
function stageOf(app, mayTest, onRunning, signal) {
  const cross = targetCross();
  const words = h("p", { class: "test-words", role: "status" });
  const time = h("div", { class: "big", "aria-hidden": "true" });
  const count = h("p", { class: "quiet" });
  const element = h(
    "section",
    { class: "card test-stage" },
    h("div", { class: "test-side" }, words, time, count),
    cross.element,
  );
  const start = h("button", { type: "button", class: "btn go large" }, t("test-start"));
  const end = h("button", { type: "button", class: "btn large" }, t("test-end-it"));
  const drive = h("a", { class: "btn", href: "#/drive" }, t("test-drive"));
  let isRunning = false;
  const setRunning = (/** @type {boolean} */ is) => {
    isRunning = is;
    start.hidden = is || !mayTest;
    end.hidden = !is || !mayTest;
    drive.hidden = is;
    onRunning(is);
    showMoment();
  };
  const showMoment = () => {
    const now = (isRunning && app.live.latest?.test) || null;
    cross.show(now);
    if (!now) {
      write(words, t(isRunning ? "test-wait" : "test-before"));
      write(time, "");
      write(count, "");
      return;
    }
    write(words, t(`test-phase-${now.phase}`));
    write(time, clock(Math.ceil(now.remaining ?? 0)));
    write(count, t("test-count", { count: now.acquired }));
  };
  /** @param {HTMLButtonElement} button @param {() => Promise<unknown>} act */
  const once = (button, act) =>
    button.addEventListener("click", async () => {
      button.disabled = true;
      await app.toasts.attempt(act);
      button.disabled = false;
    });
  once(start, async () => {
    await app.api.post("/interface-tests", { screen: app.screen.word });
    if (signal.aborted) return;
    setRunning(true);
    end.focus({ preventScroll: true });
  });
  once(end, () => app.api.post("/interface-tests/current/end"));
  app.live.addEventListener("tick", showMoment, { signal });
  return { element, buttons: [drive, end, start], setRunning };
}
