/**
 * What moves inside the simulated shirt.
 * @import { Body } from "types/requests"
 * @import { BodyConfig, Equipment } from "types/documents"
 * @typedef {Body<"put", "/equipment/body">} BodyRequest
 * @typedef {keyof typeof CHOICES | "recorded"} BodyChoice
 */
import { failureWords } from "../../api.js";
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices } from "../../widgets/fields.js";
import { addFile, fileField } from "./signal_files.js";

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
 * @param {import("../../main.js").App} app @param {Equipment} equipment
 * @param {(config: BodyRequest) => Promise<void>} onUse
 * @param {{kind: string, onKind: (kind: string) => void}} shown the choice whose settings are shown
 */
export function bodyForm(app, equipment, onUse, { kind: first, onKind }) {
  const { body, files } = equipment;
  /** @type {{kind: "recorded", file: string | undefined}} */
  const recorded = { kind: "recorded", file: body?.kind === "recorded" ? body.file : undefined };
  const more = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  /** @param {BodyRequest} config */
  const use = async (config) => {
    problem.textContent = "";
    try {
      await onUse(config);
    } catch (error) {
      problem.textContent = failureWords(error);
    }
  };
  /** @param {BodyChoice} choice */
  const choose = (choice) => {
    onKind(choice);
    put(more);
    if (choice !== "recorded") return use(CHOICES[choice]);
    const bodies = files.filter(({ kind }) => kind === "body");
    put(
      more,
      fileField(bodies, recorded),
      addFile(app),
      bodies.length > 0 &&
        h(
          "button",
          { type: "button", class: "btn go", onclick: () => use(/** @type {BodyRequest} */ (recorded)) },
          t("source-use"),
        ),
    );
  };
  const current = /** @type {BodyChoice | ""} */ (first) || (body?.kind === "person" ? body.skill : body?.kind);
  if (first === "recorded") choose(first);
  /** @type {import("../../widgets/fields.js").Choice<BodyChoice>[]} */
  const options = [
    { value: "practised", label: t("body-person-practised"), hint: t("body-person-practised-hint") },
    { value: "novice", label: t("body-person-novice"), hint: t("body-person-novice-hint") },
    { value: "visitor", label: t("body-visitor"), hint: t("body-visitor-hint") },
    { value: "recorded", label: t("body-recorded"), hint: t("body-recorded-hint") },
  ];
  return h("div", { class: "stack" }, choices(t("body-title"), options, current || null, choose), more, problem);
}
