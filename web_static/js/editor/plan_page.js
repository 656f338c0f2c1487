/** The page around the workbench: saves the plan under a name, and asks before unsaved changes are lost. */
import { drawFoot, drawPage, Fragment, h, signal } from "../preact.js";
import { t } from "../texts.js";
import { sendUnderName } from "../widgets/same_name.js";
import { Answer, AskCard } from "./ask_card.js";
import { nameFrom } from "./document.js";
import { storeDraft } from "./draft_store.js";
import { planSheet } from "./sheet.js";
import { editorStore } from "./store.js";
import { Workbench } from "./workbench.js";

/**
 * @typedef {import("./document.js").Plan} Plan
 * @typedef {import("./draft_store.js").Draft} Draft
 * @typedef {import("types/api").OwnPlanView} OwnPlanView
 */

/**
 * @param {import("../main.js").App} app @param {HTMLElement} root
 * @param {{draft: Draft, plans: {name: string}[], models: import("types/api").ModelView[], left: AbortSignal}} given
 *   plans: those whose names are taken
 */
export function showPlan(app, root, { draft: first, plans, models, left }) {
  const draft = signal(first);
  const isSaving = signal(false); // a second tap would save twice
  // The link that would leave a plan with unsaved changes.
  const asked = signal(/** @type {{link: HTMLElement | SVGElement, href: string} | null} */ (null));
  let taken = plans.map(({ name }) => name);

  /** @param {Draft} next */
  const keep = (next) => {
    draft.value = next;
    const isStored = storeDraft(next);
    window.onbeforeunload = !isStored && next.dirty ? (event) => event.preventDefault() : null;
  };
  const store = editorStore(app, {
    plan: first.document,
    models,
    left,
    onChange: (document) => keep({ ...draft.value, document, dirty: true }),
  });
  const sheet = planSheet(store);

  /** Save the plan, and tell whether it was saved. @param {(document: Plan) => Promise<OwnPlanView | null>} send */
  async function saveBy(send) {
    if (isSaving.value) return false;
    isSaving.value = true;
    const isSaved = await app.toasts.attempt(async () => {
      const document = store.finish();
      const answer = await send(document);
      if (!answer) return false;
      keep({ document: { ...document, name: answer.name }, name: answer.name, version: answer.version, dirty: false });
      taken = [...taken, answer.name];
      app.toasts.show(t("plan-saved-toast", { title: answer.title }));
      return true;
    });
    isSaving.value = false;
    return Boolean(isSaved);
  }
  const saveVersion = () =>
    saveBy((document) => {
      const { name, version } = draft.value;
      return app.api.put(`/floorplans/${name}?version=${version}`, { ...document, name });
    });
  const saveAsNew = () =>
    saveBy((document) => {
      const named = { ...document, name: nameFrom(document.title, taken) };
      return sendUnderName(app.question, (sameName) => app.api.post(`/floorplans?same_name=${sameName}`, named));
    });

  /** Before a link leaves a plan with unsaved changes, ask what to do with them. @param {MouseEvent} event */
  function askBeforeLeaving(event) {
    const link = event.target instanceof Element ? event.target.closest('a[href^="#"]') : null;
    const href = link?.getAttribute("href");
    if (!href || !draft.value.dirty || href === location.hash) return;
    event.preventDefault();
    asked.value = { link: /** @type {HTMLElement | SVGElement} */ (link), href };
  }

  const Head = () => {
    const { document, name, version, dirty } = draft.value;
    return h(
      "div",
      { class: "plan-head" },
      h("h1", { tabindex: -1 }, document.title),
      h(
        "span",
        { class: dirty ? "tag att" : "tag plain", role: "status" },
        t(dirty ? "plan-unsaved" : name ? "plan-saved" : "plan-empty", { version }),
      ),
      h("span", { class: "grow" }),
      h("a", { class: "btn small bare", href: "#/plans" }, t("plan-all")),
    );
  };
  const Ask = () => {
    const now = asked.value;
    if (!now) return null;
    const leave = () => app.go(now.href);
    const save = async () => {
      if (await (draft.value.name ? saveVersion() : saveAsNew())) leave();
    };
    const discard = () => {
      storeDraft(null);
      window.onbeforeunload = null;
      leave();
    };
    const stay = () => {
      asked.value = null;
      now.link.focus();
    };
    return h(
      AskCard,
      { asked: now, id: "leave-plan", title: t("plan-leave-title"), lead: t("plan-leave-lead"), onClose: stay },
      h(Answer, { words: t("plan-leave-save"), kind: "btn go", onClick: save }),
      h(Answer, { words: t("plan-leave-keep"), onClick: leave }),
      h(Answer, { words: t("plan-leave-throw"), onClick: discard }),
      h(Answer, { words: t("plan-leave-stay"), onClick: stay }),
    );
  };
  const Foot = () => {
    const { document, name, dirty } = draft.value;
    const isNew = name === null;
    const isOff = isSaving.value || undefined;
    const way = dirty || isNew ? "" : `#/drive/task/${name}/${document.paths[0].name}`;
    return h(
      Fragment,
      {},
      h("span", { class: "grow" }, t("plan-note")),
      h("a", { class: "btn", href: way || "#/drive", hidden: !way }, t("plan-drive")),
      h(
        "button",
        { type: "button", class: "btn go", "aria-disabled": isOff, hidden: isNew, onClick: saveVersion },
        t("plan-save"),
      ),
      h(
        "button",
        { type: "button", class: isNew ? "btn go" : "btn", "aria-disabled": isOff, onClick: saveAsNew },
        t("plan-save-new"),
      ),
    );
  };

  document.addEventListener("click", askBeforeLeaving, { capture: true, signal: left });
  left.addEventListener("abort", () => (window.onbeforeunload = null));
  root.classList.add("plan-page");
  drawPage(root, h(Fragment, {}, h(Head, {}), h(Ask, {}), h(Workbench, { store, sheet })), "in-place");
  drawFoot(root, h(Foot, {}));
}
