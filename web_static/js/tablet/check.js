/** Whether this device trusts the clinic's machine, and whether their clocks agree. */

/** @typedef {{link: string, check: string, fingerprint: string, installs: boolean, start: string, end: string, now: string, name: string}} Facts */
/** @typedef {{state: "trusted" | "not-yet" | "replaced" | "clock" | "lost", facts: Facts | null, apart: number}} Finding  apart: this device's clock minus the machine's, ms */

const LAST_TRUSTED = "bodydrive_trusted";
const PATIENCE = 8000; // ms until an answer counts as missing

/** Ask the machine over http for the facts, then over https whether this device trusts it. @returns {Promise<Finding>} */
export async function check() {
  let facts, apart;
  try {
    const asked = Date.now();
    const answer = await fetch("/facts.json", { cache: "no-store", signal: AbortSignal.timeout(PATIENCE) });
    facts = /** @type {Facts} */ (await answer.json());
    apart = (asked + Date.now()) / 2 - Date.parse(facts.now);
  } catch {
    return { state: "lost", facts: null, apart: 0 };
  }
  const here = Date.now();
  if (await isTrusted(facts)) {
    remember(facts.fingerprint);
    return { state: "trusted", facts, apart };
  }
  if (here < Date.parse(facts.start) || here > Date.parse(facts.end)) return { state: "clock", facts, apart };
  const before = remembered();
  return { state: before && before !== facts.fingerprint ? "replaced" : "not-yet", facts, apart };
}

/** A browser answers a request over https only when it trusts the certificate. @param {Facts} facts */
async function isTrusted(facts) {
  try {
    const answer = await fetch(facts.check, { cache: "no-store", signal: AbortSignal.timeout(PATIENCE) });
    return answer.ok && (await answer.json()).fingerprint === facts.fingerprint;
  } catch {
    return false;
  }
}

/** @param {string} fingerprint */
function remember(fingerprint) {
  try {
    localStorage.setItem(LAST_TRUSTED, fingerprint);
  } catch {
    // A browser that keeps nothing only misses the sentence about a replaced certificate.
  }
}

function remembered() {
  try {
    return localStorage.getItem(LAST_TRUSTED);
  } catch {
    return null;
  }
}
