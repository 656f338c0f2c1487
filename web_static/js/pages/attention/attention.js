/**
 * Who to look at: the patients who need attention with the reasons, the most urgent first; then all others.
 * @import { AttentionView, PatientAttention } from "types/api"
 * @import { ComponentChildren } from "../../preact.js"
 */
import { onNews } from "../../live/news.js";
import { drawFoot, drawPage, Fragment, h, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { Icon } from "../../widgets/icons.js";

const ASK_AGAIN = 5000; // ms, while something is worked out
const URGENT = ["drive", "deterioration", "halted"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal: left }) {
  const patients = signal(await app.api.get("/attention"));
  if (left.aborted) return;
  let timer = 0;
  let reads = 0;
  const askAgain = () => {
    clearTimeout(timer);
    if (patients.value.some(({ pending }) => pending)) timer = setTimeout(read, ASK_AGAIN);
  };
  const read = async () => {
    const number = ++reads;
    const now = await app.api.get("/attention").catch(() => patients.value);
    if (left.aborted || number !== reads) return;
    patients.value = now;
    askAgain();
  };
  const Page = () => {
    const all = patients.value;
    const others = all.filter(({ reasons }) => !reasons.length);
    const count = all.filter(({ pending }) => pending).length;
    return h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("rail-attention")),
      h("p", { class: "lead" }, t("attention-lead")),
      h("p", { class: "quiet", role: "status" }, count > 0 && t("attention-pending", { count })),
      h(
        List,
        { patients: all.filter(({ reasons }) => reasons.length) },
        h("p", { class: "card quiet" }, t(all.length ? "attention-none" : "attention-nobody")),
      ),
      h(
        "section",
        { class: "stack", hidden: !others.length },
        h("h2", {}, t("attention-others")),
        h(List, { patients: others }),
      ),
    );
  };
  onNews(app, left, { what: ["trial", "comment", "record", "session", "deletion", "restoration"] }, read);
  left.addEventListener("abort", () => clearTimeout(timer));
  drawPage(root, h(Page, {}), "body stack");
  drawFoot(
    root,
    h(Fragment, {}, h("span", { class: "grow" }), h("a", { class: "btn", href: "#/review" }, t("rail-review"))),
  );
  askAgain();
}

/**
 * Patients; it is called a list only while it has rows, because a list without any is an error to screen readers.
 * @param {{patients: PatientAttention[], children?: ComponentChildren}} list children: what stands there without rows
 */
function List({ patients, children }) {
  const rows = patients.map((patient) => h(Row, { key: patient.patient_id, patient }));
  return h("div", { class: "attention", role: rows.length ? "list" : undefined }, rows.length ? rows : children);
}

/** @param {{patient: PatientAttention}} row */
function Row({ patient: { patient_id: id, code, pseudonym, reasons } }) {
  return h(
    "div",
    { class: "card person", role: "listitem" },
    h(
      "div",
      { class: "grow stack" },
      h("div", {}, h("a", { class: "row-link", href: `#/review/${id}` }, code), " ", pseudonym),
      reasons.length > 0 &&
        h(
          "ul",
          { class: "reasons" },
          reasons.map((reason) => h(Reason, { key: keyOf(reason), patient: id, reason })),
        ),
    ),
  );
}

/** @param {AttentionView} reason */
const keyOf = ({ reason, session_id: session, trial_id: trial, sentence }) =>
  [reason, session, trial, sentence].join(" ");

/** @param {{patient: number, reason: AttentionView}} line patient: id */
function Reason({ patient, reason: { reason, number, session_id: session, trial_id: trial, sentence } }) {
  const where = trial
    ? `#/review/${patient}/trial/${trial}`
    : session && reason !== "deterioration"
      ? `#/session/${session}`
      : `#/review/${patient}`;
  return h(
    "li",
    {},
    h(
      "a",
      { class: "btn small", href: where },
      URGENT.includes(reason) && h(Icon, { name: "warning", size: 18 }),
      t(`attention-${reason}`, { count: number }),
    ),
    sentence && h("p", { class: "small" }, sentence),
  );
}
