/** Where one begins: an empty plan, one's own plans, those that come with the software, a file. */
import { h, put } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { replacedList } from "../widgets/replaced_list.js";
import { t } from "../texts.js";
import { emptyPlan } from "./document.js";
import { keepDraft, keptDraft } from "./draft_store.js";
import { importForm } from "./import_form.js";

const EDIT = "#/plans/edit";

/** @param {import("../main.js").App} app @param {HTMLElement} root @param {{plans: any[], own: any[]}} lists */
export function showPlanList(app, root, { plans, own }) {
  const mine = h("div", { class: "plan-rows" });
  const names = new Set();
  const show = (list) => {
    names.clear();
    for (const { name } of list) names.add(name);
    put(mine, list.length ? list.map(ownRow) : h("p", { class: "quiet" }, t("plans.none")));
  };
  const open = (draft) => {
    if (keepDraft(draft)) return app.go(EDIT);
    app.toasts.show(t("plans.too-large"));
    app.go(EDIT);
  };
  /** What is on the workbench and was not saved is not thrown away by a tap. */
  const openSafely = (make) => async () => {
    const kept = keptDraft();
    if (kept?.dirty && !ask.hidden) return;
    if (kept?.dirty) return askFirst(kept, make);
    await tried(make);
  };
  const tried = async (make) => {
    try {
      open(await make());
    } catch (error) {
      app.toasts.show(error.message);
    }
  };
  const ask = h("div", { class: "card ask", role: "alertdialog", hidden: true, tabindex: "-1" });
  const askFirst = (kept, make) => {
    put(
      ask,
      h("h2", {}, t("plans.unsaved.title", { title: kept.document.title })),
      h("p", {}, t("plans.unsaved.lead")),
      h(
        "div",
        { class: "spread" },
        h("button", { type: "button", class: "btn go", onclick: () => app.go(EDIT) }, t("plans.go-on")),
        h("button", { type: "button", class: "btn", onclick: () => tried(make) }, t("plans.throw")),
        h("button", { type: "button", class: "btn", onclick: () => (ask.hidden = true) }, t("cancel")),
      ),
    );
    ask.hidden = false;
    ask.scrollIntoView({ block: "nearest" });
    ask.focus();
  };
  const fresh = () => ({ document: emptyPlan(t("plans.new.title")), name: null, version: 0, dirty: false });
  const ofOwn = (plan) => async () => ({
    document: bare(await app.api.get(`/floorplans/${plan.name}`)),
    name: plan.name,
    version: (await app.api.get("/own-floorplans")).find(({ name }) => name === plan.name)?.version ?? plan.version,
    dirty: false,
  });
  const copyOf = (plan) => async () => {
    const document = bare(await app.api.get(`/floorplans/${plan.name}`));
    return {
      document: { ...document, title: t("plans.copy", { title: document.title }).slice(0, 80) },
      name: null,
      version: 0,
      dirty: true,
    };
  };
  const remove = async (plan) => {
    try {
      show(await app.api.remove(`/floorplans/${plan.name}`));
      const restore = async () => show(await app.api.post(`/floorplans/${plan.name}/restore`));
      app.toasts.show(t("plans.deleted", { title: plan.title }), {
        action: t("undo"),
        run: () => restore().catch((error) => app.toasts.show(error.message)),
      });
    } catch (error) {
      app.toasts.show(error.message);
    }
  };
  function ownRow(plan) {
    return h(
      "div",
      { class: "card plan-row" },
      h(
        "div",
        { class: "grow" },
        h("b", {}, plan.title),
        h("span", { class: "quiet small" }, t("plans.version", { name: plan.name, version: plan.version })),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("plans.open.label", { title: plan.title }),
          onclick: openSafely(ofOwn(plan)),
        },
        t("plans.open"),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small bare",
          "aria-label": t("plans.delete.label", { title: plan.title }),
          onclick: () => remove(plan),
        },
        icon("bin"),
      ),
    );
  }
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
          "aria-label": t("plans.open-copy.label", { title: plan.title }),
          onclick: openSafely(copyOf(plan)),
        },
        t("plans.open-copy"),
      ),
    );
  const kept = keptDraft();
  const replaced = replacedList(app, ["floorplan", "model"], async () => show(await app.api.get("/own-floorplans")));
  show(own);
  const brought = (draft) =>
    openSafely(() => {
      app.toasts.show(draft.words.join(" "));
      return { document: draft.document, name: null, version: 0, dirty: true };
    })();
  put(
    root,
    h(
      "div",
      { class: "body" },
      h("h1", { tabindex: "-1" }, t("plans.title")),
      h("p", { class: "lead" }, t("plans.lead")),
      kept?.dirty &&
        h(
          "p",
          { class: "kept" },
          h("a", { class: "btn go", href: EDIT }, t("plans.kept", { title: kept.document.title })),
        ),
      ask,
      h(
        "div",
        { class: "plans-columns" },
        h(
          "div",
          { class: "stack" },
          h("h2", {}, t("plans.own")),
          h(
            "div",
            {},
            h(
              "button",
              { type: "button", class: "btn go", onclick: openSafely(async () => fresh()) },
              icon("plus"),
              t("plans.new"),
            ),
          ),
          mine,
          replaced.element,
          h(
            "details",
            {},
            h("summary", {}, t("plans.bundled")),
            h(
              "div",
              { class: "plan-rows" },
              plans.filter(({ name }) => !own.some((one) => one.name === name)).map(copyRow),
            ),
          ),
        ),
        importForm(app, brought),
      ),
    ),
  );
}

/** A document without the fields that say nothing. @param {any} value @returns {any} */
function bare(value) {
  if (Array.isArray(value)) return value.map(bare);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, inner]) => inner !== null)
      .map(([name, inner]) => [name, bare(inner)]),
  );
}
