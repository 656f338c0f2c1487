/** The first page of the editor: a new plan, the clinic's own plans, the plans that come with the software, an import. */
import { h, onEscape, put } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { replacedList } from "../widgets/replaced_list.js";
import { t } from "../texts.js";
import { emptyPlan } from "./document.js";
import { storeDraft, readDraft } from "./draft_store.js";
import { importForm } from "./import_form.js";

const EDIT = "#/plans/edit";

/**
 * @typedef {import("./draft_store.js").Draft} Draft
 * @typedef {import("types/api").FloorPlanView} FloorPlanView
 * @typedef {import("types/api").OwnPlanView} OwnPlanView
 * @typedef {() => Draft | Promise<Draft>} Source where a draft comes from
 */

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{plans: FloorPlanView[], own: OwnPlanView[]}} lists */
export function showPlanList(app, root, { plans, own }) {
  const mine = h("div", { class: "plan-rows" });
  /** @param {OwnPlanView[]} list */
  const show = (list) => {
    put(mine, list.length ? list.map(ownRow) : h("p", { class: "quiet" }, t("plans-none")));
  };
  /** @param {Draft} draft */
  const open = (draft) => {
    if (storeDraft(draft)) return app.go(EDIT);
    app.toasts.show(t("plans-too-large"));
    app.go(EDIT);
  };
  /** Open a draft; ask first when it would replace one that was not saved. @param {Source} source */
  const openSafely = (source) => async () => {
    const unsaved = readDraft();
    if (unsaved?.dirty && !ask.hidden) return;
    if (unsaved?.dirty) return askFirst(unsaved, source);
    await openFrom(source);
  };
  /** @param {Source} source */
  const openFrom = (source) => app.toasts.attempt(async () => open(await source()));
  const ask = h("div", {
    class: "card ask",
    role: "alertdialog",
    "aria-labelledby": "unsaved-plan",
    hidden: true,
    tabindex: "-1",
  });
  /** @param {Draft} unsaved @param {Source} source */
  const askFirst = (unsaved, source) => {
    const before = /** @type {HTMLElement | null} */ (document.activeElement);
    const close = () => {
      ask.hidden = true;
      before?.focus();
    };
    put(
      ask,
      h("h2", { id: "unsaved-plan" }, t("plans-unsaved-title", { title: unsaved.document.title })),
      h("p", {}, t("plans-unsaved-lead")),
      h(
        "div",
        { class: "spread" },
        h("button", { type: "button", class: "btn go", onclick: () => app.go(EDIT) }, t("plans-go-on")),
        h("button", { type: "button", class: "btn", onclick: () => openFrom(source) }, t("plans-throw")),
        h("button", { type: "button", class: "btn", onclick: close }, t("cancel")),
      ),
    );
    onEscape(ask, close);
    ask.hidden = false;
    ask.scrollIntoView({ block: "nearest" });
    ask.focus();
  };
  /** @returns {Draft} */
  const newDraft = () => ({ document: emptyPlan(t("plans-new-title")), name: null, version: 0, dirty: false });
  /** @param {OwnPlanView} plan @returns {Source} */
  const ofOwn = (plan) => async () => ({
    document: withoutNulls(await app.api.get(`/floorplans/${plan.name}`)),
    name: plan.name,
    version: (await app.api.get("/own-floorplans")).find(({ name }) => name === plan.name)?.version ?? plan.version,
    dirty: false,
  });
  /** @param {FloorPlanView} plan @returns {Source} */
  const copyOf = (plan) => async () => {
    const document = withoutNulls(await app.api.get(`/floorplans/${plan.name}`));
    return {
      document: { ...document, title: t("plans-copy", { title: document.title }).slice(0, 80) },
      name: null,
      version: 0,
      dirty: true,
    };
  };
  /** @param {OwnPlanView} plan */
  const remove = (plan) =>
    app.toasts.attempt(async () => {
      show(await app.api.remove(`/floorplans/${plan.name}`));
      const restore = async () => show(await app.api.post(`/floorplans/${plan.name}/restore`));
      app.toasts.show(t("plans-deleted", { title: plan.title }), {
        action: t("undo"),
        run: () => app.toasts.attempt(restore),
      });
    });
  /** @param {OwnPlanView} plan */
  function ownRow(plan) {
    return h(
      "div",
      { class: "card plan-row" },
      h(
        "div",
        { class: "grow" },
        h("b", {}, plan.title),
        h("span", { class: "quiet small" }, t("plans-version", { name: plan.name, version: plan.version })),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("plans-open-label", { title: plan.title }),
          onclick: openSafely(ofOwn(plan)),
        },
        t("plans-open"),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small bare",
          "aria-label": t("plans-delete-label", { title: plan.title }),
          onclick: () => remove(plan),
        },
        icon("bin"),
      ),
    );
  }
  /** @param {FloorPlanView} plan */
  const copyRow = (plan) =>
    h(
      "div",
      { class: "card plan-row" },
      h("div", { class: "grow" }, h("b", {}, plan.title)),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("plans-open-copy-label", { title: plan.title }),
          onclick: openSafely(copyOf(plan)),
        },
        t("plans-open-copy"),
      ),
    );
  const unsaved = readDraft();
  const replaced = replacedList(app, ["floorplan", "model"], async () => show(await app.api.get("/own-floorplans")));
  show(own);
  /** @param {import("types/api").DraftView} imported */
  const openImport = (imported) =>
    openSafely(() => {
      app.toasts.show(imported.messages.join(" "));
      const document = /** @type {Draft["document"]} */ (imported.document); // the API does not describe its fields
      return { document, name: null, version: 0, dirty: true };
    })();
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("plans-title")),
      h("p", { class: "lead" }, t("plans-lead")),
      unsaved?.dirty &&
        h(
          "p",
          { class: "kept" },
          h("a", { class: "btn go", href: EDIT }, t("plans-kept", { title: unsaved.document.title })),
        ),
      ask,
      h(
        "div",
        { class: "plans-columns" },
        h(
          "div",
          { class: "stack" },
          h("h2", {}, t("plans-own")),
          h(
            "div",
            {},
            h(
              "button",
              { type: "button", class: "btn go", onclick: openSafely(newDraft) },
              icon("plus"),
              t("plans-new"),
            ),
          ),
          mine,
          replaced.element,
          h(
            "details",
            {},
            h("summary", {}, t("plans-bundled")),
            h(
              "div",
              { class: "plan-rows" },
              plans.filter(({ name }) => !own.some((one) => one.name === name)).map(copyRow),
            ),
          ),
        ),
        importForm(app, openImport),
      ),
    ),
  );
}

/**
 * A document without the fields that are null.
 * @template T @param {T} document @returns {T}
 */
function withoutNulls(document) {
  /** @param {unknown} value @returns {unknown} */
  const strip = (value) => {
    if (Array.isArray(value)) return value.map(strip);
    if (value === null || typeof value !== "object") return value;
    const fields = Object.entries(value).filter(([, inner]) => inner !== null);
    return Object.fromEntries(fields.map(([name, inner]) => [name, strip(inner)]));
  };
  return /** @type {T} */ (strip(document));
}
