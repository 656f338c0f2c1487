/** Calls to /api/v1. Every failure becomes one sentence that can be shown as it is. */
import { t } from "./texts.js";

const BASE = "/api/v1";
const NOT_SIGNED_IN = 401;
const STOP = "/control/stop";

/** A refusal, or no answer; the message is for people. */
export class ApiError extends Error {
  /** @param {string} sentence @param {number} status 0 when nothing answered @param {any} [choice] what could be done */
  constructor(sentence, status, choice = null) {
    super(sentence);
    this.status = status;
    this.choice = choice;
  }
}

/** What belongs to no sign-in. @param {string} path */
const isForEveryone = (path) => path === STOP || path.startsWith("/auth/");

/** The calls by method; `onSignedOut` is told when a sign-in has run out. */
export class Api {
  #signIn = 0; // counts up with each sign-in that ends

  /** @param {() => void} onSignedOut */
  constructor(onSignedOut) {
    this.onSignedOut = onSignedOut;
  }

  /** @param {string} path @returns {Promise<any>} */
  get(path) {
    return this.call("GET", path);
  }

  /** @param {string} path @param {any} [body] @returns {Promise<any>} */
  post(path, body) {
    return this.call("POST", path, body);
  }

  /** @param {string} path @param {any} body @returns {Promise<any>} */
  put(path, body) {
    return this.call("PUT", path, body);
  }

  /** @param {string} path @returns {Promise<any>} */
  remove(path) {
    return this.call("DELETE", path);
  }

  /** Send a file as multipart form. @param {string} path @param {File} file @returns {Promise<any>} */
  upload(path, file) {
    const form = new FormData();
    form.append("file", file);
    return this.call("POST", path, form);
  }

  /** A sign-in has ended: what was asked under it is answered to nobody, because the answer may name a patient. */
  forget() {
    this.#signIn += 1;
  }

  /** @param {string} method @param {string} path @param {any} [body] @returns {Promise<any>} */
  async call(method, path, body) {
    const signIn = this.#signIn;
    const answer = this.#call(method, path, body);
    const error = await answer.then(
      () => null,
      (refusal) => refusal,
    );
    if (isForEveryone(path)) return answer;
    if (error?.status === NOT_SIGNED_IN && signIn === this.#signIn) this.onSignedOut();
    return signIn === this.#signIn ? answer : new Promise(() => {});
  }

  async #call(method, path, body) {
    const isForm = body instanceof FormData;
    let answer;
    try {
      answer = await fetch(BASE + path, {
        method,
        headers: body === undefined || isForm ? {} : { "Content-Type": "application/json" },
        body: body === undefined || isForm ? body : JSON.stringify(body),
        // A stop must leave even when the page is being closed.
        keepalive: path === STOP,
      });
    } catch {
      throw new ApiError(t("error.no-answer"), 0);
    }
    const content = await answer.json().catch(() => null);
    if (answer.ok) return content;
    throw new ApiError(sentence(content, answer.status), answer.status, content?.choice);
  }
}

/** @param {any} content @param {number} status */
function sentence(content, status) {
  const detail = content?.detail;
  if (typeof detail === "string") return detail;
  if (Array.isArray(detail) && detail.length) {
    const where = (detail[0].loc ?? []).filter((part) => part !== "body").join(", ");
    return where ? `${where}: ${detail[0].msg}.` : `${detail[0].msg}.`;
  }
  return t("error.status", { status });
}
