/**
 * Facts of the program that stay as they are while it runs, such as the measures and the limits of fields: read once, before the first page.
 * @import { Reference } from "types/api"
 */
import { Api } from "./api.js";

/** What the server answered; nothing may use it before `readReference` has ended. @type {Reference} */
export let REFERENCE;

/** Read the facts where they are not known yet. */
export async function readReference() {
  REFERENCE ??= await new Api({ signedOut: () => {} }).get("/reference");
}

/**
 * The limits of a field of a request.
 * @param {string} model name of what the request holds, as in docs/protocols.md @param {string} field
 */
export const limitsOf = (model, field) => REFERENCE.limits[model][field];

/** The lengths of the text that a field of a request takes, as attributes of its input. @param {string} model @param {string} field */
export function textLimits(model, field) {
  const { shortest, longest } = limitsOf(model, field);
  return { minlength: shortest, maxlength: longest };
}

/** The smallest and the largest number that a field of a request takes, as attributes of its input. @param {string} model @param {string} field */
export function numberLimits(model, field) {
  const { minimum, maximum } = limitsOf(model, field);
  return { min: minimum, max: maximum };
}
