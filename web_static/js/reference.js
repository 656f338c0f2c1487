/**
 * Facts of the program that stay as they are while it runs, such as the measures: read once, before the first page.
 * @import { Reference } from "types/api"
 */
import { Api } from "./api.js";

/** What the server answered; nothing may use it before `readReference` has ended. @type {Reference} */
export let REFERENCE;

/** Read the facts where they are not known yet. */
export async function readReference() {
  REFERENCE ??= await new Api({ signedOut: () => {} }).get("/reference");
}
