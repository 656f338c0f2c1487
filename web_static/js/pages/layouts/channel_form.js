/**
 * The chosen channel: its name, its joint, where it is, and the ring that it is one of.
 * @import { LayoutStore } from "./store.js"
 * @import { Channel, Side } from "./layout_document.js"
 */
import { h } from "../../preact.js";
import { REFERENCE, textLimits } from "../../reference.js";
import { t } from "../../texts.js";
import { Field, Segments, Selection } from "../../widgets/fields.js";
import { jointLabel, sensorName } from "../../widgets/joint_words.js";
import { SIDES } from "../shirt/body_outline.js";
import { lampPlaces } from "../shirt/lamp_places.js";
import {
  chosenJoint,
  NEW_JOINT,
  usualJoint,
  withChannel,
  withJoint,
  withoutPlace,
  withPlace,
} from "./layout_document.js";
import { placeWords } from "./place_names.js";

const NAME = "[A-Za-z0-9][A-Za-z0-9_.\\-]*"; // what a document takes (app/quantities.py)

/** @param {{store: LayoutStore}} form */
export function ChannelForm({ store: { draft, picked, discards, change } }) {
  const index = picked.value;
  const layout = draft.value;
  const channel = layout.channels[index];
  const typed = `${index} ${discards.value}`; // fields of another channel, or of changes that were given up, begin anew
  /** @param {Partial<Channel>} changes */
  const set = (changes) => change((now) => withChannel(now, index, changes));
  /** @param {string} name */
  const setJoint = (name) => change((now) => withJoint(now, index, chosenJoint(now, name)));
  /** @param {Side} side */
  const setSide = (side) => {
    const { side: before, position } = lampPlaces(layout.channels)[index];
    const [x, y] = position;
    // The wearer's right is at the left of the front and at the right of the back.
    change((now) => withPlace(now, index, side, [side === before ? x : 1 - x, y]));
  };
  return h(
    "section",
    { class: "card stack", "data-card": "channel" },
    h("h2", {}, sensorName(channel.name)),
    h(NameField, { key: `name ${typed}`, channel, onChange: (name) => set({ name }) }),
    h(
      Field,
      { label: t("layouts-joint"), hint: t("layouts-joint-hint") },
      h(Selection, { options: jointOptions(layout.joints), chosen: channel.joint, onChange: setJoint }),
    ),
    h("p", { class: "small" }, placeWords(channel)),
    h(
      "div",
      { class: "spread" },
      h(Segments, {
        label: t("layouts-side"),
        options: SIDES.map((side) => ({ value: side, label: t(`shirt-${side}`) })),
        chosen: channel.position ? (channel.side ?? "front") : "",
        onChange: (side) => setSide(/** @type {Side} */ (side)),
      }),
      h(
        "button",
        {
          type: "button",
          class: "btn small",
          "aria-disabled": !channel.position || undefined, // it keeps the focus
          onClick: () => channel.position && change((now) => withoutPlace(now, index)),
        },
        t("layouts-place-take"),
      ),
    ),
    h(RingFields, { key: `ring ${typed} ${channel.joint}`, channel, most: layout.channels.length, onChange: set }),
  );
}

/** @param {{channel: Channel, onChange: (name: string) => void}} field */
function NameField({ channel, onChange }) {
  return h(
    Field,
    { label: t("layouts-channel-name"), hint: t("layouts-channel-name-hint") },
    h("input", {
      type: "text",
      defaultValue: channel.name,
      required: true,
      pattern: NAME,
      ...textLimits("Channel", "name"),
      autocomplete: "off",
      spellcheck: false,
      onChange: changed(onChange),
    }),
  );
}

/**
 * The ring round a limb, and the channel's place in it, which people count from 1.
 * @param {{channel: Channel, most: number, onChange: (changes: Partial<Channel>) => void}} fields most: places in a ring
 */
function RingFields({ channel: { ring = null, place = null }, most, onChange }) {
  return h(
    "details",
    { open: ring !== null },
    h("summary", {}, t("layouts-ring")),
    h("p", { class: "quiet small" }, t("layouts-ring-hint")),
    h(
      "div",
      { class: "columns" },
      h(
        Field,
        { label: t("layouts-ring-name") },
        h("input", {
          type: "text",
          defaultValue: ring ?? "",
          pattern: NAME,
          ...textLimits("Channel", "ring"),
          autocomplete: "off",
          onChange: changed((name) => onChange(name ? { ring: name } : { ring: null, place: null })),
        }),
      ),
      h(
        Field,
        { label: t("layouts-ring-place") },
        h("input", {
          type: "number",
          min: 1,
          max: most,
          step: 1,
          defaultValue: place === null ? "" : String(place + 1),
          disabled: ring === null,
          onChange: changed((number) => onChange({ place: number ? Number(number) - 1 : null })),
        }),
      ),
    ),
  );
}

/** What takes what was typed into a field when it is valid; the browser says what is wrong otherwise. @param {(text: string) => void} onChange */
export function changed(onChange) {
  return (/** @type {Event} */ { currentTarget }) => {
    const input = /** @type {HTMLInputElement} */ (currentTarget);
    if (input.reportValidity()) onChange(input.value.trim());
  };
}

/** @param {import("./layout_document.js").Joint[]} joints of the layout */
function jointOptions(joints) {
  const others = REFERENCE.usual_joints.filter((name) => !joints.some((one) => one.name === name)).map(usualJoint);
  /** @param {import("./layout_document.js").Joint} joint @param {string} group */
  const option = (joint, group) => ({ value: joint.name, label: jointLabel(joint), group });
  return [
    ...joints.map((joint) => option(joint, t("layouts-joints-here"))),
    ...others.map((joint) => option(joint, t("layouts-joints-more"))),
    { value: NEW_JOINT, label: t("layouts-joint-other"), group: t("layouts-joints-more") },
  ];
}
