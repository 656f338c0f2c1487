/** The choice of a language, each by its own name. */
import { LANGUAGE } from "../language.js";
import { t } from "../texts.js";
import { field, selection } from "./fields.js";

/** The options of a choice. @param {string[]} languages by their abbreviations */
export const languageOptions = (languages) => languages.map((value) => ({ value, label: t(`language-${value}`) }));

/** The choice of the reader's language, kept by the server; null while there is only one. @param {import("../main.js").App} app */
export function languageChoice(app) {
  const languages = app.me?.languages ?? [];
  if (languages.length < 2) return null;
  return field(
    t("language-title"),
    selection(languageOptions(languages), LANGUAGE, (language) => chooseLanguage(app, language)),
  );
}

/** Load the page again in a language. @param {import("../main.js").App} app @param {string} language */
export function chooseLanguage(app, language) {
  return app.toasts.attempt(async () => {
    await app.api.put("/auth/language", { language });
    location.reload();
  });
}
