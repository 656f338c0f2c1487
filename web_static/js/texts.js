/** The texts of the pages, by id; those of the help and of the tablet's page are loaded where they are shown. */
import { catalogue } from "./words.js";
import messages from "../words/pages.ftl.js";

export const { t, hasText, textWith } = catalogue(messages);
