/**
 * The two-minute test before driving: targets on a cross, reached with a dot, while no chair moves.
 * @import { App } from "../../main.js"
 * @import { InterfaceTestsView } from "types/api"
 * @import { ComponentChildren, ReadonlySignal, Ref } from "../../preact.js"
 */
import { newestTest, TestCourse, TestFigures } from "../../interface_test/interface_tests.js";
import { targetCross } from "../../interface_test/target_cross.js";
import { newestAnswer } from "../../live/newest_answer.js";
import {
  computed,
  drawFoot,
  drawPage,
  Fragment,
  h,
  signal,
  useFocusWithin,
  useLayoutEffect,
  useMemo,
  useRef,
  useSignal,
} from "../../preact.js";
import { emptyPage, patientHere } from "../../shell/nobody.js";
import { t } from "../../texts.js";
import { clock } from "../../widgets/format.js";
import { Made } from "../../widgets/made.js";
import { pads } from "../../widgets/pads.js";
import { WorkloadCard } from "./workload_card.js";

/** @typedef {ReturnType<typeof testStore>} TestStore */

/** @param {App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const here = patientHere(app, root);
  if (!here) return;
  if (!here.hasProfile)
    return emptyPage(root, t("drive-none-title"), t("drive-none-lead"), "#/calibrate", t("drive-none-go"));
  const path = /** @type {const} */ (`/interface-tests?patient=${here.patient.id}`);
  const [first, equipment] = await Promise.all([app.api.get(path), app.api.get("/equipment")]);
  if (left.aborted) return;
  const isVisitor = equipment.shirt?.kind === "simulator" && equipment.body?.kind === "visitor";
  const tests = newestAnswer(app, left, first, () => app.api.get(path), { what: ["test"], patient: here.patient.id });
  const store = testStore(app, tests, left);
  drawPage(root, h(Page, { store, isVisitor }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {App} app @param {ReadonlySignal<InterfaceTestsView>} tests of the patient @param {AbortSignal} left */
function testStore(app, tests, left) {
  const moment = signal(app.live.latest?.test ?? null);
  const ownTest = signal(0); // id of the test that was started here, which may not be among the tests yet; 0: none
  const isRunning = computed(() => {
    const { tests: all } = tests.value;
    return (
      all.some(({ status }) => status === "running") ||
      (ownTest.value > 0 && !all.some(({ id }) => id === ownTest.value))
    );
  });
  const start = async () => {
    ownTest.value = (await app.api.post("/interface-tests", { screen: app.screen.word })).id;
  };
  const end = () => app.api.post("/interface-tests/current/end");
  app.live.addEventListener("tick", ({ detail }) => (moment.value = detail.test), { signal: left });
  return { app, left, tests, moment, ownTest, isRunning, mayTest: app.me?.role !== "reviewer", start, end };
}

/** @param {{store: TestStore, isVisitor: boolean}} page isVisitor: a visitor moves the simulated body */
function Page({ store, isVisitor }) {
  const { app, left } = store;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("rail-interface-test")),
    h("p", { class: "lead" }, t("test-lead")),
    h(
      "div",
      { class: "stack" },
      h(Stage, { store }),
      isVisitor && h(Made, { class: "card pad-card", left, make: (gone) => pads(app, gone).element }),
      h(Results, { store }),
    ),
  );
}

/**
 * The cross with what it says; while no test runs, the figures of the newest one stand in its place.
 * @param {{store: TestStore}} stage
 */
function Stage({ store: { app, left, tests, moment, isRunning } }) {
  const cross = useMemo(targetCross, []);
  /** @type {(stage: HTMLElement | null) => void} */
  const appendCross = useMemo(() => (stage) => stage?.append(cross.element), []);
  const runs = isRunning.value;
  const now = runs ? moment.value : null;
  useLayoutEffect(() => cross.show(now), [now]);
  useLayoutEffect(() => {
    if (!left.aborted) app.root.classList.toggle("test-runs", runs);
  }, [runs]);
  return h(
    "section",
    { class: newestTest(tests.value) ? "card test-stage rests" : "card test-stage", ref: appendCross },
    h(
      "div",
      { class: "test-side" },
      h(
        "p",
        { class: "test-words", role: "status" },
        now ? t(`test-phase-${now.phase}`) : t(runs ? "test-wait" : "test-before"),
      ),
      h("div", { class: "big", "aria-hidden": "true" }, now && clock(Math.ceil(now.remaining ?? 0))),
      h("p", { class: "quiet" }, now && t("test-count", { count: now.acquired })),
    ),
  );
}

/** What the newest test came to, and all of them. @param {{store: TestStore}} results */
function Results({ store: { app, left, tests, mayTest } }) {
  const read = tests.value;
  const test = newestTest(read);
  // A card with answers stays, even when the session of the test ends.
  const isAsked = useMemo(
    () => mayTest && test?.end === "complete" && test.session_id === app.session?.session?.id,
    [test?.id],
  );
  return h(
    "div",
    { class: "stack test-results" },
    test && h(TestFigures, { key: `figures ${test.id}`, test }),
    test && isAsked && h(WorkloadCard, { key: `workload ${test.id}`, app, test }),
    test && h(TestCourse, { app, left, read }),
  );
}

/** @param {{store: TestStore}} foot */
function Foot({ store: { app, ownTest, isRunning, mayTest, start, end } }) {
  const endButton = useRef(/** @type {HTMLButtonElement | null} */ (null));
  const runs = isRunning.value;
  useLayoutEffect(() => {
    if (ownTest.value) endButton.current?.focus({ preventScroll: true });
  }, [ownTest.value]);
  useFocusWithin(".foot", ".foot .btn.go"); // when the test is over
  return h(
    Fragment,
    {},
    h("span", { class: "grow" }),
    h("a", { class: "btn", href: "#/drive", hidden: runs }, t("test-drive")),
    h(
      OnceButton,
      { app, kind: "btn large", isHidden: !runs || !mayTest, button: endButton, act: end },
      t("test-end-it"),
    ),
    h(OnceButton, { app, kind: "btn go large", isHidden: runs || !mayTest, act: start }, t("test-start")),
  );
}

/**
 * A button that is off until what it does is done.
 * @param {{app: App, kind: string, isHidden: boolean, act: () => Promise<unknown>, button?: Ref<HTMLButtonElement>,
 *   children?: ComponentChildren}} button kind: its classes
 */
function OnceButton({ app, kind, isHidden, act, button, children }) {
  const isActing = useSignal(false);
  const press = async () => {
    if (isActing.value) return;
    isActing.value = true;
    await app.toasts.attempt(act);
    isActing.value = false;
  };
  return h(
    "button",
    {
      type: "button",
      class: kind,
      hidden: isHidden,
      "aria-disabled": isActing.value || undefined,
      ref: button,
      onClick: press,
    },
    children,
  );
}
