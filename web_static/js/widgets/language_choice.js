/**
 * The choice of a language, each by its own name.
 * @import { App } from "../main.js"
 */
import { LANGUAGE } from "../language.js";
import { h } from "../preact.js";
import { t } from "../texts.js";
import { Field, Selection } from "./fields.js";

/** The options of a choice. @param {string[]} languages by their abbreviations */
export const languageOptions = (languages) => languages.map((value) => ({ value, label: t(`language-${value}`) }));

/** The languages among which a reader chooses; none while there is only one. @param {App} app */
export function languagesOf(app) {
  const languages = app.me?.languages ?? [];
  return languages.length > 1 ? languages : [];
}

/** The choice of the reader's language, kept by the server; nothing while there is only one. @param {{app: App}} choice */
export function LanguageChoice({ app }) {
  const languages = languagesOf(app);
  if (!languages.length) return null;
  const choice = h(Selection, {
    options: languageOptions(languages),
    chosen: LANGUAGE,
    onChange: (language) => chooseLanguage(app, language),
  });
  return h(Field, { label: t("language-title") }, choice);
}

/** Load the page again in a language. @param {App} app @param {string} language */
export function chooseLanguage(app, language) {
  return app.toasts.attempt(async () => {
    await app.api.put("/auth/language", { language });
    location.reload();
  });
}
