/** The details of a row of the log as words: patients by their code, changes as "before to now", nothing that is empty. */

/**
 * @param {Record<string, unknown>} details @param {Map<number, string>} codes of patients, by id
 * @returns {string}
 */
export function detailWords(details, codes) {
  const { before, now, ...rest } = details;
  const changes = isObject(before) && isObject(now) ? changed(before, now) : facts({ before, now }, codes);
  return [...facts(rest, codes), ...changes].join(" · ");
}

/** @param {Record<string, unknown>} details @param {Map<number, string>} codes @returns {string[]} */
function facts(details, codes) {
  return Object.entries(details)
    .filter(([, value]) => value !== null && value !== undefined && value !== "")
    .map(([name, value]) => {
      if (name === "patient") return codes.get(Number(value)) ?? `patient ${value}`;
      return `${name.replaceAll("_", " ")} ${valueWords(value)}`;
    });
}

/** What differs, each as "name before to now". @param {Record<string, unknown>} before @param {Record<string, unknown>} now */
function changed(before, now) {
  return Object.keys({ ...before, ...now })
    .filter((name) => JSON.stringify(before[name]) !== JSON.stringify(now[name]))
    .map((name) => `${name.replaceAll("_", " ")} ${valueWords(before[name])} to ${valueWords(now[name])}`);
}

/** @param {unknown} value @returns {string} */
function valueWords(value) {
  if (value === null || value === undefined) return "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (Array.isArray(value)) return value.map(valueWords).join(", ") || "none";
  if (isObject(value)) return Object.entries(value).map(([name, one]) => `${name.replaceAll("_", " ")} ${valueWords(one)}`).join(", ");
  return String(value);
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
function isObject(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
