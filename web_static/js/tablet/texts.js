/** The texts of the page for tablets, which is loaded over http, without those of the other pages. */
import { catalogue } from "../words.js";
import messages from "../../words/tablet.ftl.js";

export const { t } = catalogue(messages);
