/** What moves inside the simulated shirt. */
import { t } from "../../texts.js";
import { h, put } from "../../widgets/dom.js";
import { choices } from "../../widgets/fields.js";
import { addFile, fileField } from "./source_form.js";

const CHOICES = {
  practised: { kind: "person", skill: "practised", seed: 1 },
  novice: { kind: "person", skill: "novice", seed: 1 },
  visitor: { kind: "visitor" },
};

/** In one line who moves. @param {any} body */
export function bodyWords(body) {
  if (body.kind === "person") return t(`body.person.${body.skill}`);
  return body.kind === "recorded" ? t("body.recorded.now", { file: body.file }) : t("body.yours");
}

/**
 * A choice takes effect at once; only a recorded body first needs its file.
 * @param {import("../../main.js").App} app @param {any} equipment @param {(config: any) => Promise<void>} onUse
 * @param {{kind: string, onKind: (kind: string) => void}} shown the choice whose settings are shown
 */
export function bodyForm(app, equipment, onUse, { kind: first, onKind }) {
  const { body, files } = equipment;
  const recorded = { kind: "recorded", file: body?.file };
  const more = h("div", { class: "stack settings" });
  const problem = h("p", { class: "problem", role: "alert" });
  const use = async (config) => {
    problem.textContent = "";
    try {
      await onUse(config);
    } catch (error) {
      problem.textContent = error.message;
    }
  };
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
        h("button", { type: "button", class: "btn go", onclick: () => use(recorded) }, t("source.use")),
    );
  };
  const current = first || (body?.kind === "person" ? body.skill : body?.kind);
  if (first === "recorded") choose(first);
  const options = [
    { value: "practised", label: t("body.person.practised"), hint: t("body.person.practised.hint") },
    { value: "novice", label: t("body.person.novice"), hint: t("body.person.novice.hint") },
    { value: "visitor", label: t("body.visitor"), hint: t("body.visitor.hint") },
    { value: "recorded", label: t("body.recorded"), hint: t("body.recorded.hint") },
  ];
  return h("div", { class: "stack" }, choices(t("body.title"), options, current, choose), more, problem);
}
