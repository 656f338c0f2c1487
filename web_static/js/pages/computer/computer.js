/**
 * This computer, for owners: measured for ten seconds on a tap, with the pictures a second of each open screen.
 * @import { ComputerView, FindingView } from "types/api"
 */
import { ApiError, FORBIDDEN, failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put, write } from "../../widgets/dom.js";
import { icon } from "../../widgets/icons.js";

const SECONDS = 10; // s
const SHOW_EVERY = 250; // ms
const ICONS = /** @type {const} */ ({ good: "tick", attention: "warning", bad: "cross" });

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  if (app.me?.role !== "owner") throw new ApiError(t("computer-owner"), FORBIDDEN);
  const go = h("button", { type: "button", class: "btn go" }, t("computer-go", { seconds: SECONDS }));
  const course = measuringCourse(signal);
  const problem = h("p", { class: "problem", role: "alert" });
  const place = h("div", { class: "stack" });
  const measure = async () => {
    go.disabled = true;
    write(problem, "");
    put(place);
    course.begin();
    try {
      const found = await app.api.post("/computer/measurement", { seconds: SECONDS });
      if (signal.aborted) return;
      put(place, results(found));
    } catch (error) {
      if (!signal.aborted) write(problem, failureWords(error));
    } finally {
      course.end();
      go.disabled = false;
      write(go, t("computer-again"));
    }
    place.querySelector("h2")?.focus();
  };
  go.addEventListener("click", measure);
  put(
    root,
    h(
      "div",
      { class: "body stack" },
      h("div", {}, h("h1", { tabindex: "-1" }, t("rail-computer")), h("p", { class: "lead" }, t("computer-lead"))),
      h(
        "section",
        { class: "card stack" },
        h("p", {}, t("computer-measured")),
        h("div", {}, go),
        course.element,
        problem,
      ),
      place,
      h("div", {}, h("a", { class: "btn small", href: "#/settings" }, t("people-back"))),
    ),
  );
}

/** That it is being measured, and for how long still. @param {AbortSignal} signal */
function measuringCourse(signal) {
  const words = h("p", { class: "unseen", role: "status" }); // written once: each change is read out
  const left = h("p", { class: "number", "aria-hidden": "true" });
  const bar = h("progress", { max: SECONDS, value: 0, "aria-label": t("computer-progress"), hidden: true });
  let timer = 0;
  let since = 0;
  const draw = () => {
    const time = (performance.now() - since) / 1000;
    bar.value = Math.min(SECONDS, time);
    write(left, time < SECONDS ? t("computer-measuring", { left: Math.ceil(SECONDS - time) }) : t("computer-counting"));
  };
  const begin = () => {
    since = performance.now();
    bar.hidden = false;
    write(words, t("computer-measuring", { left: SECONDS }));
    draw();
    timer = setInterval(draw, SHOW_EVERY);
  };
  const end = () => {
    clearInterval(timer);
    bar.hidden = true;
    write(words, "");
    write(left, "");
  };
  signal.addEventListener("abort", end);
  return { element: h("div", { class: "measuring" }, words, left, bar), begin, end };
}

/** @param {ComputerView} found */
function results({ machine, screens }) {
  const failing = screens.filter(({ verdict }) => verdict === "bad").length;
  const worst = failing ? "bad" : machine.verdict;
  const words = failing ? `${machine.message} ${t("computer-screens-bad", { count: failing })}` : machine.message;
  return [
    h(
      "section",
      { class: `card findings ${worst}` },
      h("h2", { tabindex: "-1" }, t("computer-machine")),
      h("p", { class: "summary" }, mark({ verdict: worst }), h("b", {}, words)),
      list(machine.findings),
    ),
    h(
      "section",
      { class: "card findings" },
      h("h2", {}, t("computer-screens")),
      screens.length ? list(screens) : h("p", { class: "quiet" }, t("computer-no-screens")),
    ),
  ];
}

/** @param {FindingView[]} findings */
function list(findings) {
  return h(
    "ul",
    {},
    findings.map((finding) => h("li", {}, mark(finding), h("span", {}, finding.message))),
  );
}

/** A sign and, for those who do not see it, a word. @param {{verdict: FindingView["verdict"]}} finding */
function mark({ verdict }) {
  return h(
    "span",
    { class: `mark ${verdict}` },
    icon(ICONS[verdict], 20),
    h("span", { class: "unseen" }, t(`computer-verdict-${verdict}`), ": "),
  );
}
