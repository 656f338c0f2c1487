/**
 * What the live socket of the patient's screen delivers (app/api/patient_screen/patient_picture.py).
 * @import { ScreenSettings } from "types/api"
 * @import { Moment, TrialMoment } from "../live/live.js"
 * @typedef {"id" | "t" | "done" | "length" | "stage" | "stages" | "instruction" | "target" | "movers"} TrialField
 */

/**
 * @typedef {object} PatientCue a cue of a calibration
 * @property {number} index
 * @property {string} kind
 * @property {string | null} movement in words
 * @property {number} t s since its start
 * @property {number} length s
 * @property {string | null} next kind of the cue after it
 */

/**
 * @typedef {object} PatientFields
 * @property {{name: string, words: string} | null} fault
 * @property {{for: string, words: string}} waits for whom the chair waits, and the words to say so
 * @property {Pick<TrialMoment, TrialField> | null} trial
 * @property {boolean} drives
 * @property {PatientCue | null} cue
 * @property {{id: number, end: string} | null} over the trial that has ended last
 * @property {ScreenSettings} asks what the clinician wants this screen to show
 */

/** @typedef {Moment & PatientFields} PatientMessage */

export {};
