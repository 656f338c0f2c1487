/** The first page of the editor: a new plan, the clinic's own plans, the plans that come with the software, an import. */
import { passFocus } from "../focus.js";
import { drawPage, Fragment, h, signal } from "../preact.js";
import { t } from "../texts.js";
import { Icon } from "../widgets/icons.js";
import { replacedList } from "../widgets/replaced_list.js";
import { Answer, AskCard } from "./ask_card.js";
import { emptyPlan } from "./document.js";
import { storeDraft, readDraft } from "./draft_store.js";
import { ImportForm } from "./import_form.js";

const EDIT = "#/plans/edit";

/**
 * @typedef {import("./draft_store.js").Draft} Draft
 * @typedef {import("types/api").FloorPlanView} FloorPlanView
 * @typedef {import("types/api").OwnPlanView} OwnPlanView
 * @typedef {() => Draft | Promise<Draft>} Source where a draft comes from
 * @typedef {{title: string, source: Source, before: HTMLElement | null}} Asked the title of the draft that was not saved,
 *   where another one comes from, and what had the focus
 */

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{plans: FloorPlanView[], own: OwnPlanView[]}} lists */
export function showPlanList(app, root, { plans, own: first }) {
  const own = signal(first);
  const asked = signal(/** @type {Asked | null} */ (null));
  const kept = readDraft();
  const bundled = plans.filter(({ name }) => !first.some((one) => one.name === name));
  const readOwn = async () => void (own.value = await app.api.get("/own-floorplans"));
  const { ReplacedList } = replacedList(app, ["floorplan", "model"], readOwn);
  /** @param {Draft} draft */
  const open = (draft) => {
    if (storeDraft(draft)) return app.go(EDIT);
    app.toasts.show(t("plans-too-large"));
    app.go(EDIT);
  };
  /** @param {Source} source */
  const openFrom = (source) => app.toasts.attempt(async () => open(await source()));
  /** Open a draft; ask first when it would replace one that was not saved. @param {Source} source */
  const openSafely = async (source) => {
    const unsaved = readDraft();
    if (!unsaved?.dirty) await openFrom(source);
    else if (!asked.value) {
      const before = /** @type {HTMLElement | null} */ (document.activeElement);
      asked.value = { title: unsaved.document.title, source, before };
    }
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
  /** @param {import("types/api").DraftView} imported */
  const openImport = (imported) =>
    openSafely(() => {
      app.toasts.show(imported.messages.join(" "));
      const document = /** @type {Draft["document"]} */ (imported.document); // the API does not describe its fields
      return { document, name: null, version: 0, dirty: true };
    });
  /** @param {OwnPlanView} plan */
  const remove = (plan) =>
    app.toasts.attempt(async () => {
      own.value = await app.api.remove(`/floorplans/${plan.name}`);
      const restore = async () => void (own.value = await app.api.post(`/floorplans/${plan.name}/restore`));
      app.toasts.show(t("plans-deleted", { title: plan.title }), {
        action: t("undo"),
        run: () => app.toasts.attempt(restore),
      });
    });

  const Ask = () => {
    const now = asked.value;
    if (!now) return null;
    const close = () => {
      asked.value = null;
      now.before?.focus();
    };
    return h(
      AskCard,
      {
        asked: now,
        id: "unsaved-plan",
        title: t("plans-unsaved-title", { title: now.title }),
        lead: t("plans-unsaved-lead"),
        onClose: close,
      },
      h(Answer, { words: t("plans-go-on"), kind: "btn go", onClick: () => app.go(EDIT) }),
      h(Answer, { words: t("plans-throw"), onClick: () => openFrom(now.source) }),
      h(Answer, { words: t("cancel"), onClick: close }),
    );
  };
  const OwnPlans = () =>
    h(
      "div",
      { class: "plan-rows" },
      own.value.map((plan) =>
        h(OwnRow, { key: plan.name, plan, onOpen: () => openSafely(ofOwn(plan)), onRemove: remove }),
      ),
      !own.value.length && h("p", { class: "quiet" }, t("plans-none")),
    );

  drawPage(
    root,
    h(
      Fragment,
      {},
      h("h1", { tabindex: -1 }, t("plans-title")),
      h("p", { class: "lead" }, t("plans-lead")),
      kept?.dirty &&
        h(
          "p",
          { class: "kept" },
          h("a", { class: "btn go", href: EDIT }, t("plans-kept", { title: kept.document.title })),
        ),
      h(Ask, {}),
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
              { type: "button", class: "btn go", onClick: () => openSafely(newDraft) },
              h(Icon, { name: "plus" }),
              t("plans-new"),
            ),
          ),
          h(OwnPlans, {}),
          h(ReplacedList, {}),
          h(
            "details",
            {},
            h("summary", {}, t("plans-bundled")),
            h(
              "div",
              { class: "plan-rows" },
              bundled.map((plan) => h(CopyRow, { key: plan.name, plan, onOpen: () => openSafely(copyOf(plan)) })),
            ),
          ),
        ),
        h(ImportForm, { app, onOpen: openImport }),
      ),
    ),
  );
}

/** @param {{plan: OwnPlanView, onOpen: () => unknown, onRemove: (plan: OwnPlanView) => unknown}} row */
function OwnRow({ plan, onOpen, onRemove }) {
  const { name, title, version } = plan;
  return h(
    "div",
    { class: "card plan-row" },
    h(
      "div",
      { class: "grow" },
      h("b", {}, title),
      h("span", { class: "quiet small" }, t("plans-version", { name, version })),
    ),
    h(
      "button",
      { type: "button", class: "btn small", "aria-label": t("plans-open-label", { title }), onClick: onOpen },
      t("plans-open"),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small bare",
        "aria-label": t("plans-delete-label", { title }),
        ref: passFocus,
        onClick: () => onRemove(plan),
      },
      h(Icon, { name: "bin" }),
    ),
  );
}

/** @param {{plan: FloorPlanView, onOpen: () => unknown}} row */
function CopyRow({ plan: { title }, onOpen }) {
  return h(
    "div",
    { class: "card plan-row" },
    h("div", { class: "grow" }, h("b", {}, title)),
    h(
      "button",
      { type: "button", class: "btn small", "aria-label": t("plans-open-copy-label", { title }), onClick: onOpen },
      t("plans-open-copy"),
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
