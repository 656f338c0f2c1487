/**
 * The list of layouts: those of the clinic, those that come with the program, and the ways to a new one.
 * @import { LayoutsView, ShirtLayout } from "types/api"
 * @import { Equipment, ShirtKind } from "types/documents"
 * @import { OwnLayout } from "./store.js"
 * @typedef {LayoutsView["bundled"][number]} BundledLayout
 */
import { passFocus } from "../../focus.js";
import { newestAnswer } from "../../live/newest_answer.js";
import { drawPage, Fragment, h } from "../../preact.js";
import { t } from "../../texts.js";
import { Icon } from "../../widgets/icons.js";
import { nameOfNew } from "./layout_document.js";
import { NewLayout } from "./new_layout.js";
import { putLayout, whyNotUsed } from "./use_layout.js";

const KEPT = 10_000; // ms for which a browser may read an exported file

/**
 * @typedef {object} List
 * @property {import("../../main.js").App} app
 * @property {import("../../preact.js").Signal<LayoutsView>} layouts
 * @property {import("../../preact.js").ReadonlySignal<Equipment>} equipment
 * @property {ShirtKind[]} kinds
 */

/**
 * @param {import("../../main.js").App} app @param {HTMLElement} root
 * @param {{first: LayoutsView, equipment: List["equipment"], kinds: ShirtKind[], left: AbortSignal}} page
 */
export function showLayoutList(app, root, { first, equipment, kinds, left }) {
  const layouts = newestAnswer(app, left, first, () => app.api.get("/layouts"), { what: ["layouts", "equipment"] });
  drawPage(root, h(Page, { list: { app, layouts, equipment, kinds } }));
}

/** @param {{list: List}} page */
function Page({ list }) {
  const { own, bundled } = list.layouts.value;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("rail-layouts")),
    h("p", { class: "lead" }, t("layouts-lead")),
    h(
      "div",
      { class: "main-columns" },
      h(
        "div",
        { class: "stack" },
        h("h2", {}, t("layouts-own")),
        h(
          "div",
          { class: "stack", role: own.length ? "list" : undefined },
          own.length
            ? own.map((entry) => h(OwnRow, { key: entry.id, list, entry }))
            : h("p", { class: "quiet" }, t("layouts-none")),
        ),
        h("h2", {}, t("layouts-bundled")),
        h(
          "div",
          { class: "stack", role: "list" },
          bundled.map((entry) => h(Row, { key: entry.layout.name, list, entry })),
        ),
      ),
      h(NewLayout, { list, onSaved: (name) => openNamed(list, name) }),
    ),
  );
}

/** @param {{list: List, entry: OwnLayout}} row */
function OwnRow({ list, entry }) {
  const { app, layouts } = list;
  const { name } = entry.layout;
  const remove = () =>
    app.toasts.attempt(async () => {
      layouts.value = await app.api.remove(`/layouts/${entry.id}`);
      const restore = async () => void (layouts.value = await app.api.post("/layouts", entry.layout));
      app.toasts.show(t("layouts-deleted", { name }), {
        action: t("undo"),
        run: () => app.toasts.attempt(restore),
      });
    });
  return h(
    Row,
    { list, entry },
    h(
      "a",
      {
        class: "btn small",
        href: `#/layouts/edit/${entry.id}`,
        "aria-label": t("layouts-edit-label", { name }),
      },
      t("layouts-edit"),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn small bare",
        "aria-label": t("layouts-delete-label", { name }),
        ref: passFocus,
        onClick: remove,
      },
      h(Icon, { name: "bin" }),
    ),
  );
}

/** @param {{list: List, entry: OwnLayout | BundledLayout, children?: import("../../preact.js").ComponentChildren}} row */
function Row({ list, entry: { layout, use }, children }) {
  const { app, layouts, equipment, kinds } = list;
  const { name, channels, joints } = layout;
  const duplicate = () =>
    app.toasts.attempt(async () => {
      const copy = nameOfNew(t("layouts-copy", { name }), layouts.value);
      layouts.value = await app.api.post("/layouts", { ...layout, name: copy });
      openNamed(list, copy);
    });
  const canBeUsed = use !== "same" && whyNotUsed(equipment.value, kinds) === "";
  return h(
    "div",
    { class: "card layout-row", role: "listitem" },
    h(
      "div",
      { class: "grow" },
      h("b", {}, name),
      use !== "none" && h("span", { class: "tag calm" }, t(`layouts-use-${use}`)),
      h("div", { class: "quiet small" }, t("layouts-counts", { channels: channels.length, joints: joints.length })),
    ),
    h(
      "div",
      { class: "spread" },
      canBeUsed &&
        h(
          "button",
          {
            type: "button",
            class: "btn small",
            "aria-label": t("layouts-use-label", { name }),
            ref: passFocus,
            onClick: () => putLayout(app, equipment.value, layout),
          },
          t("layouts-use"),
        ),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("layouts-duplicate-label", { name }),
          onClick: duplicate,
        },
        t("layouts-duplicate"),
      ),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-label": t("layouts-export-label", { name }),
          onClick: () => exportLayout(layout),
        },
        t("layouts-export"),
      ),
      children,
    ),
  );
}

/** Open the editor of the clinic's layout of this name. @param {List} list @param {string} name */
function openNamed({ app, layouts }, name) {
  const entry = layouts.value.own.find(({ layout }) => layout.name === name);
  if (entry) app.go(`#/layouts/edit/${entry.id}`);
}

/** Let the browser save a layout as a file. @param {ShirtLayout} layout */
function exportLayout(layout) {
  const address = URL.createObjectURL(new Blob([JSON.stringify(layout, null, 2)], { type: "application/json" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = `${layout.name}.layout.json`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), KEPT);
}
