/** The page round the workbench: what is saved under which name, and what happens to it when one leaves. */
import { h, put, write } from "../widgets/dom.js";
import { sendUnderName } from "../widgets/same_name.js";
import { t } from "../texts.js";
import { nameFrom } from "./document.js";
import { keepDraft, keptDraft } from "./draft_store.js";
import { workbench } from "./workbench.js";

const CHOSEN = "bodydrive-path"; // what the Drive page looks at

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{plans: any[], models: any[], signal: AbortSignal}} given */
export function showPlan(app, root, { plans, models, signal }) {
  let draft = keptDraft();
  let taken = plans.map(({ name }) => name);
  const title = h("h1", { tabindex: "-1" }, draft.document.title);
  const saved = h("span", { class: "tag plain", role: "status" });
  const ask = h("div", { class: "card ask", role: "alertdialog", hidden: true, tabindex: "-1" });
  const save = h("button", { type: "button", class: "btn go", onclick: () => saveVersion() }, t("plan.save"));
  const saveNew = h("button", { type: "button", class: "btn", onclick: () => saveAsNew() }, t("plan.save-new"));
  const drive = h("a", { class: "btn", href: "#/drive", onclick: () => chooseToDrive() }, t("plan.drive"));

  const keep = (next) => {
    const wasKept = keepDraft((draft = next));
    if (!wasKept && next.dirty) window.onbeforeunload = (event) => event.preventDefault();
    else window.onbeforeunload = null;
    show();
  };
  const show = () => {
    write(title, draft.document.title);
    saved.className = draft.dirty ? "tag att" : "tag plain";
    write(
      saved,
      t(draft.dirty ? "plan.unsaved" : draft.name ? "plan.saved" : "plan.empty", { version: draft.version }),
    );
    save.hidden = draft.name === null;
    saveNew.classList.toggle("go", draft.name === null);
    drive.hidden = draft.dirty || draft.name === null;
  };
  const bench = workbench(app, {
    plan: draft.document,
    models,
    signal,
    onChange: (document) => keep({ ...draft, document, dirty: true }),
  });

  async function sent(run) {
    save.disabled = saveNew.disabled = true; // a second tap would save twice
    try {
      const document = bench.plan();
      const answer = await run(document);
      if (!answer) return false;
      keep({ document: { ...document, name: answer.name }, name: answer.name, version: answer.version, dirty: false });
      taken = [...taken, answer.name];
      app.toasts.show(t("plan.saved.toast", { title: answer.title }));
      return true;
    } catch (error) {
      app.toasts.show(error.message);
      return false;
    } finally {
      save.disabled = saveNew.disabled = false;
    }
  }
  const saveVersion = () =>
    sent((document) =>
      app.api.put(`/floorplans/${draft.name}?version=${draft.version}`, { ...document, name: draft.name }),
    );
  const saveAsNew = () =>
    sent((document) => {
      const named = { ...document, name: nameFrom(document.title, taken) };
      return sendUnderName(app.question, (sameName) => app.api.post(`/floorplans?same_name=${sameName}`, named));
    });

  function chooseToDrive() {
    localStorage.setItem(CHOSEN, `${draft.name}/${draft.document.paths[0].name}`);
  }

  function throwAway(leave) {
    keepDraft(null);
    window.onbeforeunload = null;
    leave();
  }

  /** A tap on a link of the frame or of this page asks first, when something is not saved. */
  function leaving(event) {
    const link = event.target.closest?.('a[href^="#"]');
    if (!link || !draft.dirty || link.getAttribute("href") === location.hash) return;
    event.preventDefault();
    const leave = () => app.go(link.getAttribute("href"));
    put(
      ask,
      h("h2", {}, t("plan.leave.title")),
      h("p", {}, t("plan.leave.lead")),
      h(
        "div",
        { class: "spread" },
        h(
          "button",
          {
            type: "button",
            class: "btn go",
            onclick: async () => (await (draft.name ? saveVersion() : saveAsNew())) && leave(),
          },
          t("plan.leave.save"),
        ),
        h("button", { type: "button", class: "btn", onclick: leave }, t("plan.leave.keep")),
        h("button", { type: "button", class: "btn", onclick: () => throwAway(leave) }, t("plan.leave.throw")),
        h("button", { type: "button", class: "btn", onclick: () => (ask.hidden = true) }, t("plan.leave.stay")),
      ),
    );
    ask.hidden = false;
    ask.focus();
  }

  document.addEventListener("click", leaving, { capture: true, signal });
  signal.addEventListener("abort", () => (window.onbeforeunload = null));
  put(
    root,
    h(
      "div",
      { class: "plan-head" },
      title,
      saved,
      h("span", { class: "grow" }),
      h("a", { class: "btn small bare", href: "#/plans" }, t("plan.all")),
    ),
    ask,
    bench.element,
    h("div", { class: "foot" }, h("span", { class: "grow" }, t("plan.note")), drive, save, saveNew),
  );
  root.classList.add("plan-page");
  show();
}
