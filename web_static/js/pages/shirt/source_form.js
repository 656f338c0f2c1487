/**
 * Where the movements come from: the form, and the configuration that it makes.
 * @import { ShirtLayout } from "types/api"
 * @import { Body } from "types/requests"
 * @import { ShirtStore } from "./store.js"
 * @import { ShirtConfig, ShirtKind } from "types/documents"
 * @typedef {Body<"put", "/equipment/shirt">} ShirtRequest
 */
import { computed, Fragment, h, useLayoutEffect, useMemo, useRef, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { ChoiceForm } from "./choice_form.js";
import { configFields } from "./config_fields.js";
import { SourceChoices } from "./source_choices.js";

/** In one line what is in use. @param {ShirtConfig | null} shirt @param {ShirtKind[]} shirts */
export function sourceWords(shirt, shirts) {
  if (!shirt) return t("source-none");
  const form = shirts.find(({ kind }) => kind === shirt.kind)?.form;
  return (form?.in_use ?? shirt.kind).replace(/\{(\w+)\}/g, (_, name) => String(shirt[name]));
}

/** @param {{store: ShirtStore, onUse: (config: ShirtRequest) => Promise<void>}} form */
export function SourceForm({ store: { app, kinds, equipment }, onUse }) {
  const first = useMemo(() => equipment.peek().shirt, []);
  const kind = useSignal(first?.kind ?? "");
  const layouts = useSignal(/** @type {ShirtLayout[]} */ ([]));
  const settings = useRef(/** @type {HTMLDivElement | null} */ (null));
  useLayoutEffect(() => {
    if (app.me?.role === "reviewer") return; // who only looks sees no layouts
    app.api.get("/layouts").then(
      ({ own, bundled }) => void (layouts.value = [...own, ...bundled].map((one) => one.layout)),
      () => null, // a file can be brought all the same
    );
  }, []);
  const parts = useMemo(() => {
    const chosen = kinds.find((one) => one.kind === kind.value);
    if (!chosen) return null;
    return configFields(chosen.form, {
      app,
      now: first?.kind === chosen.kind ? first : null,
      layout: computed(() => equipment.value.layout),
      files: computed(() => equipment.value.files),
      keys: computed(() => equipment.value.shirt_keys),
      found: computed(() => equipment.value.status.found),
      layouts,
    });
  }, [kind.value]);
  useLayoutEffect(() => {
    // They are the next step. Of more than the window holds, their beginning comes into view.
    if (kind.value !== (first?.kind ?? "")) settings.current?.scrollIntoView({ block: "nearest" });
  }, [kind.value]);
  return h(
    ChoiceForm,
    {
      choices: h(SourceChoices, { kinds, chosen: kind.value, onChoose: (chosen) => void (kind.value = chosen) }),
      onUse: async () => void (parts && (await onUse(/** @type {ShirtRequest} */ (await parts.config())))),
      place: settings,
      isReady: parts !== null,
    },
    h(Fragment, { key: kind.value }, parts?.fields),
  );
}
