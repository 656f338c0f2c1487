/**
 * What the editor of a layout has: the document with its changes, the chosen channel, and which channels move now.
 * @import { LayoutsView, ShirtLayout } from "types/api"
 * @import { Equipment, ShirtKind } from "types/documents"
 * @import { ReadonlySignal } from "../../preact.js"
 * @typedef {LayoutsView["own"][number]} OwnLayout
 * @typedef {ReturnType<typeof layoutStore>} LayoutStore
 */
import { failureWords } from "../../api.js";
import { movingNow } from "../../live/moving_channels.js";
import { computed, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { forgetDraft, readDraft, storeDraft } from "./draft_store.js";
import { wrongRing } from "./layout_document.js";

/** @type {number[]} */
const NONE = [];

/**
 * @param {import("../../main.js").App} app @param {OwnLayout} entry the layout that is edited
 * @param {ReadonlySignal<Equipment>} equipment @param {ShirtKind[]} kinds of shirts @param {AbortSignal} left of the page
 */
export function layoutStore(app, entry, equipment, kinds, left) {
  const saved = signal(entry);
  const draft = signal(readDraft(entry.id, entry.saved) ?? entry.layout);
  const picked = signal(0); // index of a channel
  const problem = signal(""); // why it was not saved
  const isSending = signal(false);
  const discards = signal(0); // how often changes were given up: what was typed goes with them
  const isChanged = computed(() => draft.value !== saved.value.layout);
  /** Whether what arrives now has as many channels as the layout, so that they can be seen to move. */
  const isLive = computed(() => equipment.value.layout?.channels.length === draft.value.channels.length);
  const { moving: arriving } = movingNow(app.live, left);
  const moving = computed(() => (isLive.value ? arriving.value : NONE));
  /** @param {(layout: ShirtLayout) => ShirtLayout} made makes the next document of the present one */
  const change = (made) => {
    draft.value = made(draft.peek());
    problem.value = "";
    storeDraft(entry.id, { saved: saved.value.saved, layout: draft.value });
  };
  /** Give the changes up. */
  const discard = () => {
    forgetDraft(entry.id);
    draft.value = saved.value.layout;
    problem.value = "";
    discards.value += 1;
  };
  const save = async () => {
    if (isSending.value) return;
    const { id, version } = saved.value;
    const { value: sent } = draft;
    const wrong = wrongRing(sent);
    problem.value = wrong ? t("layouts-ring-places", wrong) : "";
    if (wrong) return;
    isSending.value = true;
    try {
      const layout = { ...sent, name: sent.name.trim() };
      const { own } = await app.api.put(`/layouts/${id}`, { version, layout });
      const now = own.find((one) => one.id === id);
      if (now) saved.value = now;
      if (draft.value === sent) {
        forgetDraft(id);
        draft.value = saved.value.layout;
      }
      app.toasts.show(t("layouts-saved", { name: layout.name }));
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };
  return {
    app,
    left,
    kinds,
    equipment,
    saved,
    draft,
    picked,
    moving,
    problem,
    isSending,
    discards,
    isChanged,
    isLive,
    change,
    discard,
    save,
  };
}
