/**
 * This computer, for owners: measured for ten seconds on a tap, with the pictures a second of each open screen.
 * @import { ComputerView, FindingView } from "types/api"
 */
import { ApiError, FORBIDDEN, failureWords } from "../../api.js";
import { drawPage, Fragment, h, signal, useOpening } from "../../preact.js";
import { t } from "../../texts.js";
import { Icon } from "../../widgets/icons.js";

const SECONDS = 10; // s
const SHOW_EVERY = 250; // ms
const ICONS = /** @type {const} */ ({ good: "tick", attention: "warning", bad: "cross" });

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  if (app.me?.role !== "owner") throw new ApiError(t("computer-owner"), FORBIDDEN);
  const time = signal(/** @type {number | null} */ (null)); // s since the measurement began; null: none goes on
  const measured = signal(/** @type {ComputerView | null} */ (null));
  const problem = signal("");
  const again = signal(false); // whether it was measured before
  const measure = async () => {
    if (time.value !== null) return;
    const since = performance.now();
    [time.value, measured.value, problem.value] = [0, null, ""];
    const timer = setInterval(() => (time.value = (performance.now() - since) / 1000), SHOW_EVERY);
    left.addEventListener("abort", () => clearInterval(timer));
    try {
      measured.value = await app.api.post("/computer/measurement", { seconds: SECONDS });
    } catch (error) {
      problem.value = failureWords(error);
    }
    clearInterval(timer);
    [time.value, again.value] = [null, true];
  };
  const Measurement = () =>
    h(
      "section",
      { class: "card stack" },
      h("p", {}, t("computer-measured")),
      h(
        "div",
        {},
        h(
          "button",
          { type: "button", class: "btn go", "aria-disabled": time.value !== null || undefined, onClick: measure },
          again.value ? t("computer-again") : t("computer-go", { seconds: SECONDS }),
        ),
      ),
      h(Course, { time: time.value }),
      h("p", { class: "problem", role: "alert" }, problem.value),
    );
  const Results = () => {
    const place = useOpening(measured.value, "h2");
    return h("div", { class: "stack", ref: place }, measured.value && results(measured.value));
  };
  drawPage(
    root,
    h(
      Fragment,
      {},
      h("div", {}, h("h1", { tabindex: -1 }, t("rail-computer")), h("p", { class: "lead" }, t("computer-lead"))),
      h(Measurement, {}),
      h(Results, {}),
      h("div", {}, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
    "body stack",
  );
}

/** That it is being measured, and for how long still. @param {{time: number | null}} course s since it began */
function Course({ time }) {
  const left = Math.ceil(SECONDS - (time ?? 0));
  return h(
    "div",
    { class: "measuring" },
    // Read out, therefore without the seconds that go by.
    h("p", { class: "unseen", role: "status" }, time !== null && t("computer-measuring", { left: SECONDS })),
    h(
      "p",
      { class: "number", "aria-hidden": "true" },
      time !== null && (left > 0 ? t("computer-measuring", { left }) : t("computer-counting")),
    ),
    h("progress", {
      max: SECONDS,
      value: Math.min(SECONDS, time ?? 0),
      "aria-label": t("computer-progress"),
      hidden: time === null,
    }),
  );
}

/** @param {ComputerView} measured */
function results({ machine, screens }) {
  const failing = screens.filter(({ verdict }) => verdict === "bad").length;
  const worst = failing ? "bad" : machine.verdict;
  const words = failing ? `${machine.message} ${t("computer-screens-bad", { count: failing })}` : machine.message;
  return h(
    Fragment,
    {},
    h(
      "section",
      { class: `card findings ${worst}` },
      h("h2", { tabindex: -1 }, t("computer-machine")),
      h("p", { class: "summary" }, mark(worst), h("b", {}, words)),
      list(machine.findings),
    ),
    h(
      "section",
      { class: "card findings" },
      h("h2", {}, t("computer-screens")),
      screens.length ? list(screens) : h("p", { class: "quiet" }, t("computer-no-screens")),
    ),
  );
}

/** @param {FindingView[]} findings */
const list = (findings) =>
  h(
    "ul",
    {},
    findings.map(({ verdict, message }) => h("li", {}, mark(verdict), h("span", {}, message))),
  );

/** A sign and, for those who do not see it, a word. @param {FindingView["verdict"]} verdict */
const mark = (verdict) =>
  h(
    "span",
    { class: `mark ${verdict}` },
    h(Icon, { name: ICONS[verdict], size: 20 }),
    h("span", { class: "unseen" }, t(`computer-verdict-${verdict}`), ": "),
  );
