/**
 * The editor of a layout: its channels in a list and on the body, the form of the chosen one, its joints.
 * @import { ShirtKind } from "types/documents"
 * @import { LayoutStore, OwnLayout } from "./store.js"
 */
import { giveFocus } from "../../focus.js";
import { drawFoot, drawPage, Fragment, h, useLayoutEffect, useRef } from "../../preact.js";
import { textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Field } from "../../widgets/fields.js";
import { jointWithin, sensorName } from "../../widgets/joint_words.js";
import { BodyPlaces } from "./body_places.js";
import { ChannelForm } from "./channel_form.js";
import { JointsCard } from "./joints_card.js";
import { withPlace } from "./layout_document.js";
import { placeWords } from "./place_names.js";
import { layoutStore } from "./store.js";
import { putLayout, whyNotUsed } from "./use_layout.js";

/**
 * @param {import("../../main.js").App} app @param {HTMLElement} root
 * @param {{entry: OwnLayout, equipment: LayoutStore["equipment"], kinds: ShirtKind[], left: AbortSignal}} page
 */
export function showLayoutEditor(app, root, { entry, equipment, kinds, left }) {
  const store = layoutStore(app, entry, equipment, kinds, left);
  drawPage(root, h(Page, { store }));
  drawFoot(root, h(Foot, { store }));
}

/** @param {{store: LayoutStore}} page */
function Page({ store }) {
  const { draft, isLive, equipment } = store;
  const count = draft.value.channels.length;
  const arriving = equipment.value.layout?.channels.length ?? 0;
  return h(
    Fragment,
    {},
    h("h1", { tabindex: -1 }, t("layouts-edit-title", { name: store.saved.value.layout.name })),
    h("p", { class: "lead" }, isLive.value ? t("layouts-lead-live") : t("layouts-lead-not-live", { arriving, count })),
    h(
      "div",
      { class: "main-columns" },
      h("div", { class: "stack" }, h(BodyCard, { store }), h(JointsCard, { store })),
      h("div", { class: "stack" }, h(ChannelList, { store }), h(ChannelForm, { store }), h(NameCard, { store })),
    ),
  );
}

/** @param {{store: LayoutStore}} card */
function BodyCard({ store: { draft, picked, moving, change } }) {
  return h(
    "section",
    { class: "card" },
    h("h2", {}, t("layouts-body"), h("span", { class: "quiet small" }, t("layouts-body-hint"))),
    h(BodyPlaces, {
      layout: draft.value,
      picked: picked.value,
      moving: moving.value,
      onPick: (index) => void (picked.value = index),
      onPlace: (index, side, position) => change((now) => withPlace(now, index, side, position)),
    }),
  );
}

/** @param {{store: LayoutStore}} list */
function ChannelList({ store: { draft, picked, moving } }) {
  const { channels, joints } = draft.value;
  const list = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    const chosen = list.current?.children[picked.value];
    if (!chosen || !list.current) return;
    // Only the list scrolls: the page stays where the finger is.
    const { offsetTop, offsetHeight } = /** @type {HTMLElement} */ (chosen);
    const { scrollTop, clientHeight } = list.current;
    if (offsetTop < scrollTop) list.current.scrollTop = offsetTop;
    else if (offsetTop + offsetHeight > scrollTop + clientHeight)
      list.current.scrollTop = offsetTop + offsetHeight - clientHeight;
  }, [picked.value]);
  return h(
    "section",
    { class: "card" },
    h(
      "h2",
      {},
      t("layouts-list"),
      h("span", { class: "quiet small" }, t("layouts-channels", { count: channels.length })),
    ),
    h(
      "div",
      { class: "layout-list", role: "radiogroup", "aria-label": t("layouts-list"), ref: list },
      channels.map((channel, i) => {
        const isMoving = moving.value.includes(i);
        const joint = joints.find(({ name }) => name === channel.joint);
        return h(
          "label",
          { class: "choice layout-channel", key: i, "data-moving": isMoving || undefined },
          h("input", {
            type: "radio",
            name: "layout-channel",
            checked: i === picked.value,
            onChange: () => void (picked.value = i),
          }),
          h(
            "span",
            { class: "grow" },
            h("b", {}, sensorName(channel.name)),
            h("span", {}, t("layouts-row", { joint: joint ? jointWithin(joint) : "", place: placeWords(channel) })),
          ),
          h("i", { class: "layout-lamp", "aria-hidden": "true" }),
          isMoving && h("span", { class: "unseen" }, t("layouts-moves")),
        );
      }),
    ),
  );
}

/** @param {{store: LayoutStore}} card */
function NameCard({ store: { draft, change } }) {
  return h(
    "section",
    { class: "card" },
    h(
      Field,
      { label: t("layouts-name") },
      h("input", {
        type: "text",
        value: draft.value.name,
        required: true,
        ...textLimits("ShirtLayout", "name"),
        autocomplete: "off",
        onInput: (/** @type {Event} */ { currentTarget }) => {
          const name = /** @type {HTMLInputElement} */ (currentTarget).value;
          change((now) => ({ ...now, name }));
        },
      }),
    ),
  );
}

/** @param {{store: LayoutStore}} foot */
function Foot({ store }) {
  const { app, kinds, equipment, saved, isChanged, isSending, problem, save, discard } = store;
  const why = whyNotUsed(equipment.value, kinds);
  const back = useRef(/** @type {HTMLAnchorElement | null} */ (null));
  const useIt = useRef(/** @type {HTMLButtonElement | null} */ (null));
  const wasShown = useRef(false);
  useLayoutEffect(() => {
    if (wasShown.current) giveFocus(useIt.current, back.current); // what was pressed has gone
    wasShown.current = true;
  }, [isChanged.value]);
  return h(
    Fragment,
    {},
    h("p", { class: "foot-line", role: "alert" }, problem.value),
    h("span", { class: "grow" }, isChanged.value ? t("layouts-unsaved") : why || t("layouts-calibrations")),
    h("a", { class: "btn", href: "#/layouts", ref: back }, t("layouts-back")),
    h("button", { type: "button", class: "btn", hidden: !isChanged.value, onClick: discard }, t("layouts-discard")),
    h(
      "button",
      {
        type: "button",
        class: "btn go",
        hidden: !isChanged.value,
        "aria-disabled": isSending.value || undefined,
        onClick: save,
      },
      t("layouts-save"),
    ),
    h(
      "button",
      {
        type: "button",
        class: "btn go",
        hidden: isChanged.value || why !== "",
        ref: useIt,
        onClick: () => putLayout(app, equipment.value, saved.value.layout),
      },
      t("layouts-use"),
    ),
  );
}
