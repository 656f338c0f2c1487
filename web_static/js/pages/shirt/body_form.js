/**
 * What moves inside the simulated shirt.
 * @import { Body } from "types/requests"
 * @import { BodyConfig } from "types/documents"
 * @typedef {Body<"put", "/equipment/body">} BodyRequest
 * @typedef {keyof typeof CHOICES | "recorded"} BodyChoice
 */
import { failureWords } from "../../api.js";
import { Fragment, h, useMemo, useSignal } from "../../preact.js";
import { t } from "../../texts.js";
import { Choices } from "../../widgets/fields.js";
import { AddFile, FileField } from "./signal_files.js";

const CHOICES = /** @type {const} */ ({
  practised: { kind: "person", skill: "practised", seed: 1 },
  novice: { kind: "person", skill: "novice", seed: 1 },
  visitor: { kind: "visitor" },
});

/** In one line who moves. @param {BodyConfig} body */
export function bodyWords(body) {
  if (body.kind === "person") return t(`body-person-${body.skill}`);
  return body.kind === "recorded" ? t("body-recorded-now", { file: body.file }) : t("body-yours");
}

/**
 * A choice takes effect at once; only a recorded body first needs its file.
 * @param {{store: import("./store.js").ShirtStore, onUse: (config: BodyRequest) => Promise<void>}} form
 */
export function BodyForm({ store: { app, equipment }, onUse }) {
  const { body, files } = equipment.value;
  const chosen = useSignal(/** @type {BodyChoice | null} */ (null));
  const problem = useSignal("");
  const recorded = useMemo(() => {
    const file = body?.kind === "recorded" ? body.file : undefined;
    return { kind: /** @type {const} */ ("recorded"), file };
  }, []);
  const bodies = files.filter(({ kind }) => kind === "body");
  /** @param {BodyRequest} config */
  const use = async (config) => {
    problem.value = "";
    try {
      await onUse(config);
    } catch (error) {
      problem.value = failureWords(error);
    }
  };
  /** @param {string} value */
  const choose = (value) => {
    const choice = (chosen.value = /** @type {BodyChoice} */ (value));
    if (choice !== "recorded") use(CHOICES[choice]);
  };
  /** @param {BodyChoice} value @param {string} name */
  const option = (value, name) => ({ value, label: t(name), hint: t(`${name}-hint`) });
  return h(
    "div",
    { class: "stack" },
    h(Choices, {
      label: t("body-title"),
      options: [
        option("practised", "body-person-practised"),
        option("novice", "body-person-novice"),
        option("visitor", "body-visitor"),
        option("recorded", "body-recorded"),
      ],
      chosen: chosen.value ?? (body?.kind === "person" ? body.skill : (body?.kind ?? null)),
      onChange: choose,
    }),
    h(
      "div",
      { class: "stack settings" },
      chosen.value === "recorded" &&
        h(
          Fragment,
          {},
          h(FileField, { files: bodies, config: recorded }),
          h(AddFile, { app }),
          bodies.length > 0 &&
            h(
              "button",
              {
                type: "button",
                class: "btn go",
                onClick: () => use(/** @type {BodyRequest} */ ({ ...recorded })),
              },
              t("source-use"),
            ),
        ),
    ),
    h("p", { class: "problem", role: "alert" }, problem),
  );
}
