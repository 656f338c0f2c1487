/**
 * What the page of an import shows: the file, what the server says of it, and what a person has corrected. The server
 * keeps nothing in between, so each request carries the file.
 * @import { RecordingOverview, StoredRecording } from "types/api"
 * @typedef {{column: string, joint: string}} Channel
 * @typedef {{part: string | null, time: string | null, unit: string | null, rate: number | null,
 *   channels: Channel[] | null}} Corrections null: as the file says; `time` empty: no column is the time
 * @typedef {ReturnType<typeof importStore>} ImportStore
 */
import { failureWords } from "../../api.js";
import { computed, signal } from "../../preact.js";
import { t } from "../../texts.js";
import { sendUnderName } from "../../widgets/same_name.js";

/** @type {Corrections} */
const AS_THE_FILE_SAYS = { part: null, time: null, unit: null, rate: null, channels: null };

/** @param {import("../../main.js").App} app @param {AbortSignal} left of the page */
export function importStore(app, left) {
  const { api } = app; // the page's own instance: its changes name the session that this page was opened for
  /** @type {File[]} */
  let files = [];
  const corrections = signal(AS_THE_FILE_SAYS);
  const overview = signal(/** @type {RecordingOverview | null} */ (null));
  const problem = signal("");
  const isReading = signal(false);
  const isRead = signal(false); // whether the overview is that of the file with all corrections
  const isSending = signal(false);
  /** The columns that become channels, each with its joint. */
  const channels = computed(() => corrections.value.channels ?? (overview.value ? channelsOf(overview.value) : []));
  let requests = 0;

  /** @param {Channel[] | null} chosen */
  const form = (chosen) => {
    const sent = new FormData();
    for (const file of files) sent.append("files", file);
    sent.append("options", JSON.stringify({ ...corrections.value, channels: chosen }));
    return sent;
  };

  const read = async () => {
    const request = ++requests;
    problem.value = "";
    isReading.value = true;
    isRead.value = false;
    /** @type {RecordingOverview | null} */
    let answer = null;
    let words = "";
    try {
      const sent = form(corrections.value.channels);
      answer = /** @type {RecordingOverview} */ (await api.call("POST", "/equipment/files/overview", sent));
    } catch (error) {
      words = failureWords(error);
    }
    if (request !== requests || left.aborted) return; // a person has corrected something else meanwhile
    isReading.value = false;
    isRead.value = answer !== null;
    problem.value = words;
    overview.value = answer ?? overview.value;
  };

  /** @param {File[]} chosen */
  const choose = (chosen) => {
    requests++; // what is still being read is of another file
    files = chosen;
    corrections.value = AS_THE_FILE_SAYS;
    overview.value = null;
    isReading.value = false;
    if (chosen.length) read();
  };

  /** Correct something, and read the file again with that. @param {Partial<Corrections>} corrected */
  const correct = (corrected) => {
    const next = { ...corrections.value, ...corrected };
    const others = next.channels?.filter(({ column }) => column !== next.time) ?? null; // the time is no channel
    corrections.value = { ...next, channels: others };
    if (others?.length !== 0) read();
  };

  /** Leave a column in or out. @param {string} column @param {boolean} isIn */
  const setChannel = (column, isIn) => {
    const chosen = new Map(channels.value.map((channel) => [channel.column, channel.joint]));
    const all = overview.value?.columns ?? [];
    const next = all.filter(({ name }) => (name === column ? isIn : chosen.has(name)));
    correct({ channels: next.map(({ name, joint }) => ({ column: name, joint: chosen.get(name) ?? joint ?? "" })) });
  };

  /** @param {string} column @param {string} joint */
  const setJoint = (column, joint) => {
    const changed = channels.value.map((channel) => (channel.column === column ? { column, joint } : channel));
    corrections.value = { ...corrections.value, channels: changed }; // it changes nothing in how the file is read
  };

  /** Store the recording, and play it as the shirt if `isUsed`. @param {boolean} isUsed */
  const store = async (isUsed) => {
    if (isSending.value) return;
    problem.value = "";
    isSending.value = true;
    try {
      const stored = await sendUnderName(app.question, (sameName) =>
        api.call("POST", `/equipment/files/import?same_name=${sameName}`, form(channels.value)),
      );
      if (stored) {
        const { name } = /** @type {StoredRecording} */ (stored);
        app.toasts.show(t("source-added", { file: name }));
        if (isUsed && !left.aborted) {
          await api.put("/equipment/shirt", { kind: "replay", file: name, loop: true });
          if (!left.aborted) app.go("#/shirt");
        }
      }
    } catch (error) {
      problem.value = failureWords(error);
    }
    isSending.value = false;
  };

  return {
    corrections,
    overview,
    problem,
    isReading,
    isRead,
    isSending,
    channels,
    choose,
    correct,
    setChannel,
    setJoint,
    store,
  };
}

/** The columns that the server reads as channels. @param {RecordingOverview} overview @returns {Channel[]} */
function channelsOf({ columns }) {
  return columns
    .filter(({ role, joint }) => role === "channel" && joint !== null)
    .map(({ name, joint }) => ({ column: name, joint: joint ?? "" }));
}
