/**
 * Calls to /api/v1. Every failure becomes one sentence that can be shown as it is.
 * @import { Answer, Body, Known } from "types/requests"
 */

/**
 * How to go on with an upload whose name is in use, with a 3D object whose size is improbable, or with an archive whose
 * patient is here.
 * @typedef {{proposed: string, may_replace: boolean}} NameChoice `proposed`: a free name
 * @typedef {{may_replace_patient: boolean}} PatientChoice
 * @typedef {{scales: {metres_per_unit: number, size: number[]}[]}} ObjectScales `size`: m
 */
import { t } from "./texts.js";

const BASE = "/api/v1";
const NOT_SIGNED_IN = 401;
/** Status of an answer for somebody who may not ask, also of a page that knows so before it asks. */
export const FORBIDDEN = 403;
const LOCKED = 423;
const CONFLICT = 409;
const STOP = "/control/stop";
const STOP_BY_KEY = `${STOP}?by=key`;
const ALWAYS = new Set([STOP, STOP_BY_KEY, "/auth/sign-out"]);

/** A refusal, or no answer; the message is for people. */
export class ApiError extends Error {
  /**
   * @param {string} sentence @param {number} status 0 when nothing answered
   * @param {NameChoice | ObjectScales | PatientChoice | null} [choice] what could be done about it
   */
  constructor(sentence, status, choice = null) {
    super(sentence);
    this.status = status;
    this.choice = choice;
  }
}

/** The sentence of a failure, for people. @param {unknown} error */
export function failureWords(error) {
  return error instanceof Error ? error.message : String(error);
}

/** Whether a path belongs to no sign-in. @param {string} path */
const isForEveryone = (path) => path.startsWith(STOP) || path.startsWith("/auth/");

let signIns = 0; // counts up with each sign-in that ends, for the calls of every page

/**
 * The calls by method; `on.signedOut` is called when a sign-in has run out, `on.locked` when it is locked. Each change names the session that the page
 * shows (docs/protocols.md, section 4), so that nothing meant for one patient reaches another one.
 */
export class Api {
  /**
   * @param {{signedOut: () => void, locked?: () => void}} on what to do then
   * @param {number | null} [session] id of the session that the page shows, null: nobody is here
   */
  constructor(on, session = null) {
    this.on = on;
    this.session = session;
    this.isOver = false;
  }

  /** Send no further change: the session of this page is no longer open. Stop and sign-out are still sent. */
  end() {
    this.isOver = true;
  }

  /** @template {string} const P @param {P & Known<"get", P>} path @returns {Promise<Answer<"get", P>>} */
  get(path) {
    return this.call("GET", path);
  }

  /**
   * @template {string} const P
   * @param {P & Known<"post", P>} path @param {Body<"post", P>} [body] @returns {Promise<Answer<"post", P>>}
   */
  post(path, body) {
    return this.call("POST", path, body);
  }

  /**
   * @template {string} const P
   * @param {P & Known<"put", P>} path @param {Body<"put", P>} body @returns {Promise<Answer<"put", P>>}
   */
  put(path, body) {
    return this.call("PUT", path, body);
  }

  /**
   * @template {string} const P
   * @param {P & Known<"delete", P>} path @param {Body<"delete", P>} [body] @returns {Promise<Answer<"delete", P>>}
   */
  remove(path, body) {
    return this.call("DELETE", path, body);
  }

  /**
   * Send a file as multipart form.
   * @template {string} const P @param {P & Known<"post", P>} path @param {File} file @returns {Promise<Answer<"post", P>>}
   */
  upload(path, file) {
    const form = new FormData();
    form.append("file", file);
    return this.call("POST", path, form);
  }

  /**
   * Send a file as it is; it may be larger than the memory.
   * @template {string} const P @param {P & Known<"post", P>} path @param {File} file @returns {Promise<Answer<"post", P>>}
   */
  send(path, file) {
    return this.call("POST", path, file);
  }

  /** A sign-in has ended: drop the answers to its requests, because they may name a patient. */
  forget() {
    signIns += 1;
  }

  /**
   * Send a request. The answer is what the route of the path answers.
   * @template Content @param {string} method @param {string} path @param {unknown} [body] @returns {Promise<Content>}
   */
  async call(method, path, body) {
    const signIn = signIns;
    const answer = this.#call(method, path, body);
    const error = await answer.then(
      () => null,
      (refusal) => refusal,
    );
    if (isForEveryone(path)) return answer;
    if (error?.status === NOT_SIGNED_IN && signIn === signIns) this.on.signedOut();
    if (error?.status === LOCKED && signIn === signIns) this.on.locked?.();
    return signIn === signIns ? answer : new Promise(() => {});
  }

  /** @param {string} method @param {string} path @param {unknown} body */
  async #call(method, path, body) {
    if (this.isOver && method !== "GET" && !ALWAYS.has(path)) throw new ApiError(t("session-over"), CONFLICT);
    const isFile = body instanceof FormData || body instanceof Blob;
    /** @type {Record<string, string>} */
    const headers = method === "GET" ? {} : { "Patient-Session": String(this.session ?? "none") };
    if (body !== undefined && !isFile) headers["Content-Type"] = "application/json";
    let answer;
    try {
      answer = await fetch(BASE + path, {
        method,
        headers,
        body: body === undefined || isFile ? body : JSON.stringify(body),
        // A stop must leave even when the page is being closed.
        keepalive: path.startsWith(STOP),
      });
    } catch {
      throw new ApiError(t("error-no-answer"), 0);
    }
    const content = await answer.json().catch(() => null);
    if (answer.ok) return content;
    throw new ApiError(sentence(content, answer.status), answer.status, content?.choice);
  }
}

/**
 * The sentence of a refusal: the server's own, or of the first field that it did not accept.
 * @param {{detail?: string | {loc?: (string | number)[], msg: string}[]} | null} content @param {number} status
 */
function sentence(content, status) {
  const detail = content?.detail;
  if (typeof detail === "string") return detail;
  if (Array.isArray(detail) && detail.length) {
    const where = (detail[0].loc ?? []).filter((part) => part !== "body").join(", ");
    return where ? `${where}: ${detail[0].msg}.` : `${detail[0].msg}.`;
  }
  return t("error-status", { status });
}
