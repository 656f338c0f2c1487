/** The page around the workbench: saves the plan under a name, and asks before unsaved changes are lost. */
import { h, onEscape, put, write } from "../widgets/dom.js";
import { sendUnderName } from "../widgets/same_name.js";
import { t } from "../texts.js";
import { nameFrom } from "./document.js";
import { storeDraft } from "./draft_store.js";
import { workbench } from "./workbench.js";

/**
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./draft_store.js").Draft} Draft
 * @typedef {import("types/api").OwnPlanView} OwnPlanView
 */

/**
 * @param {import("../main.js").App} app @param {HTMLElement} root
 * @param {{draft: Draft, plans: {name: string}[], models: import("types/api").ModelView[], signal: AbortSignal}} given
 *   plans: those whose names are taken
 */
export function showPlan(app, root, { draft: first, plans, models, signal }) {
  let draft = first;
  let taken = plans.map(({ name }) => name);
  const title = h("h1", { tabindex: "-1" }, draft.document.title);
  const saved = h("span", { class: "tag plain", role: "status" });
  const ask = h("div", {
    class: "card ask",
    role: "alertdialog",
    "aria-labelledby": "leave-plan",
    hidden: true,
    tabindex: "-1",
  });
  const save = h("button", { type: "button", class: "btn go", onclick: () => saveVersion() }, t("plan-save"));
  const saveNew = h("button", { type: "button", class: "btn", onclick: () => saveAsNew() }, t("plan-save-new"));
  const drive = h("a", { class: "btn", href: "#/drive" }, t("plan-drive"));

  /** @param {Draft} next */
  const keep = (next) => {
    const isStored = storeDraft((draft = next));
    if (!isStored && next.dirty) window.onbeforeunload = (event) => event.preventDefault();
    else window.onbeforeunload = null;
    show();
  };
  const show = () => {
    write(title, draft.document.title);
    saved.className = draft.dirty ? "tag att" : "tag plain";
    write(
      saved,
      t(draft.dirty ? "plan-unsaved" : draft.name ? "plan-saved" : "plan-empty", { version: draft.version }),
    );
    save.hidden = draft.name === null;
    saveNew.classList.toggle("go", draft.name === null);
    drive.hidden = draft.dirty || draft.name === null;
    if (!drive.hidden) drive.href = `#/drive/task/${draft.name}/${draft.document.paths[0].name}`;
  };
  const bench = workbench(app, {
    plan: draft.document,
    models,
    signal,
    onChange: (document) => keep({ ...draft, document, dirty: true }),
  });

  /** Save the plan, and tell whether it was saved. @param {(document: Plan) => Promise<OwnPlanView | null>} send */
  async function saveBy(send) {
    save.disabled = saveNew.disabled = true; // a second tap would save twice
    const isSaved = await app.toasts.attempt(async () => {
      const document = bench.plan();
      const answer = await send(document);
      if (!answer) return false;
      keep({ document: { ...document, name: answer.name }, name: answer.name, version: answer.version, dirty: false });
      taken = [...taken, answer.name];
      app.toasts.show(t("plan-saved-toast", { title: answer.title }));
      return true;
    });
    save.disabled = saveNew.disabled = false;
    return Boolean(isSaved);
  }
  const saveVersion = () =>
    saveBy((document) =>
      app.api.put(`/floorplans/${draft.name}?version=${draft.version}`, { ...document, name: draft.name }),
    );
  const saveAsNew = () =>
    saveBy((document) => {
      const named = { ...document, name: nameFrom(document.title, taken) };
      return sendUnderName(app.question, (sameName) => app.api.post(`/floorplans?same_name=${sameName}`, named));
    });

  /** @param {() => void} leave */
  function discard(leave) {
    storeDraft(null);
    window.onbeforeunload = null;
    leave();
  }

  /** Before a link leaves a plan with unsaved changes, ask what to do with them. @param {MouseEvent} event */
  function askBeforeLeaving(event) {
    const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
    const href = link?.getAttribute("href");
    if (!href || !draft.dirty || href === location.hash) return;
    event.preventDefault();
    const leave = () => app.go(href);
    const stay = () => {
      ask.hidden = true;
      /** @type {HTMLElement | SVGElement} */ (link).focus();
    };
    put(
      ask,
      h("h2", { id: "leave-plan" }, t("plan-leave-title")),
      h("p", {}, t("plan-leave-lead")),
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
          t("plan-leave-save"),
        ),
        h("button", { type: "button", class: "btn", onclick: leave }, t("plan-leave-keep")),
        h("button", { type: "button", class: "btn", onclick: () => discard(leave) }, t("plan-leave-throw")),
        h("button", { type: "button", class: "btn", onclick: stay }, t("plan-leave-stay")),
      ),
    );
    onEscape(ask, stay);
    ask.hidden = false;
    ask.focus();
  }

  document.addEventListener("click", askBeforeLeaving, { capture: true, signal });
  signal.addEventListener("abort", () => (window.onbeforeunload = null));
  put(
    root,
    h(
      "div",
      { class: "plan-head" },
      title,
      saved,
      h("span", { class: "grow" }),
      h("a", { class: "btn small bare", href: "#/plans" }, t("plan-all")),
    ),
    ask,
    bench.element,
    h("div", { class: "foot" }, h("span", { class: "grow" }, t("plan-note")), drive, save, saveNew),
  );
  root.classList.add("plan-page");
  show();
}
