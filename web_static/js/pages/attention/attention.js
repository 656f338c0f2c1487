/**
 * Who to look at: the patients who need attention with the reasons, the most urgent first; then all others.
 * @import { AttentionView, PatientAttention } from "types/api"
 */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { icon } from "../../widgets/icons.js";
import { rowList } from "../../widgets/list.js";

const ASK_AGAIN = 5000; // ms, while something is worked out
const CHANGES = ["trial", "record", "session", "everything"];
const URGENT = ["drive", "deterioration", "halted"];

/** @param {import("../../main.js").App} app @param {HTMLElement} root @param {{signal: AbortSignal}} page */
export async function show(app, root, { signal }) {
  let found = await app.api.get("/attention");
  if (signal.aborted) return;
  const needed = rowList("attention");
  const others = rowList("attention");
  const rest = h("section", { class: "stack" }, h("h2", {}, t("attention-others")), others);
  const pending = h("p", { class: "quiet", role: "status" });
  let timer = 0;
  const draw = () => {
    const [some, none] = [found.filter((one) => one.reasons.length), found.filter((one) => !one.reasons.length)];
    needed.show(
      some.map(row),
      h("p", { class: "card quiet" }, t(found.length ? "attention-none" : "attention-nobody")),
    );
    others.show(none.map(row));
    rest.hidden = !none.length;
    const count = found.filter((one) => one.pending).length;
    put(pending, count > 0 && t("attention-pending", { count }));
    clearTimeout(timer);
    if (count) timer = setTimeout(read, ASK_AGAIN);
  };
  const read = async () => {
    const now = await app.api.get("/attention").catch(() => found);
    if (signal.aborted) return;
    found = now;
    draw();
  };
  app.live.addEventListener("changed", ({ detail }) => CHANGES.includes(detail) && read(), { signal });
  signal.addEventListener("abort", () => clearTimeout(timer));
  put(
    root,
    h(
      "div",
      { class: "body stack" },
      h("h1", { tabindex: "-1" }, t("rail-attention")),
      h("p", { class: "lead" }, t("attention-lead")),
      pending,
      needed,
      rest,
    ),
    h(
      "div",
      { class: "foot" },
      h("span", { class: "grow" }),
      h("a", { class: "btn", href: "#/review" }, t("rail-review")),
    ),
  );
  draw();
}

/** @param {PatientAttention} patient */
function row({ patient_id: id, code, pseudonym, reasons }) {
  return h(
    "div",
    { class: "card person" },
    h(
      "div",
      { class: "grow stack" },
      h("div", {}, h("a", { class: "row-link", href: `#/review/${id}` }, code), " ", pseudonym),
      reasons.length > 0 &&
        h(
          "ul",
          { class: "reasons" },
          reasons.map((one) => reasonLine(id, one)),
        ),
    ),
  );
}

/** @param {number} patient id @param {AttentionView} reason */
function reasonLine(patient, { reason, number, session_id: session, trial_id: trial, sentence }) {
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
      URGENT.includes(reason) && icon("warning", 18),
      t(`attention-${reason}`, { count: number }),
    ),
    sentence && h("p", { class: "small" }, sentence),
  );
}
