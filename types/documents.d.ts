/** Parts of answers that the OpenAPI document leaves open: what the routes fill in (docs/protocols.md, section 4). */
import type { CalibrationView, components, EquipmentView, LearningView, MapCheck, MapView, ShirtKindView } from "./api";

type Schemas = components["schemas"];

/** One thing to do, from `start` to `end` in s of the run. */
export type Cue = {
  start: number;
  end: number;
  kind: string;
  joint: string | null;
  repetition: number;
};

export type CalibrationStep = {
  id: string;
  kind: string;
  joint: string | null;
  title: string;
  /** Its name in a few letters: the joint. */
  label: string;
  instruction: string;
  duration: number;
  cues: Cue[];
  status: string;
  /** Why a step failed; empty otherwise. */
  message: string;
};

/** An expected number with its uncertainty, one standard deviation. */
export type Forecast = { value: number; uncertainty: number };

/** How a ring of so many sensors sits otherwise than on other people; at which places it has its front and its outer side, null: not known. */
export type Arrangement = {
  shift: number;
  mirrored: boolean;
  sensors: number;
  front: number | null;
  outside: number | null;
};

/** What a map that is not the standard one is learnt from, its checks, and what is expected of it; null: not known. */
export type MapResult = {
  offered: boolean;
  people: number; // 0: from own prompts alone
  repetitions: number;
  dropped: string[];
  arrangement: Record<string, Arrangement>;
  as_worn: Record<string, Arrangement>; // rings that look so, and that a person is sure sit right
  hits: Forecast | null;
  hits_with_prompts: Forecast | null; // after three repetitions of a movement that was not prompted yet
  false_per_minute: Forecast | null;
  check: MapCheck | null; // on repetitions that the map had not seen
  pca_check: MapCheck | null; // of the standard map, on the same ones
};

/** A joint of a calibration's result; what was not measured is null. */
export type JointResult = {
  name: string;
  label: string;
  step: string | null;
  has_to_be_repeated: boolean; // its movement is too weak or too uneven to drive with
  advice: string | null; // null: there is nothing to heed
  evr: number | null;
  signal_to_noise: number | null;
  repeatability: number | null;
  map: "pca" | "guided" | "prior" | null;
  guided: MapResult | null;
  prior: MapResult | null;
};

export type CalibrationResult = {
  joints: JointResult[];
  cross_talk: number[][] | null;
  left_out: Record<string, string>;
  accepted: boolean;
};

export type Calibration = Omit<CalibrationView, "steps" | "result"> & {
  steps: CalibrationStep[];
  result: CalibrationResult | null;
};

/** Configurations (docs/protocols.md, section 2) as they are answered: with every field. */
export type ShirtConfig = { kind: string; sample_rate?: number; [field: string]: unknown };
export type BodyConfig =
  Required<Schemas["PersonConfig"]> | Required<Schemas["VisitorConfig"]> | Required<Schemas["RecordedConfig"]>;
export type HeadConfig =
  | Required<Schemas["OpentrackConfig"]>
  | Required<Schemas["FreepieConfig"]>
  | Required<Schemas["FlockOfBirdsConfig"]>
  | Required<Schemas["SimulatedHeadConfig"]>
  | Required<Schemas["RecordedHeadConfig"]>
  | Required<Schemas["TabletHeadConfig"]>;

/** The schema of a field of a shirt's configuration, with the words and marks of docs/drivers.md. */
export type FieldSchema = {
  title?: string;
  description?: string;
  type?: string;
  format?: string;
  unit?: string;
  const?: string;
  default?: unknown;
  minimum?: number;
  maximum?: number;
  minLength?: number;
  maxLength?: number;
  examples?: (string | number)[];
  enum?: (string | number)[];
  titles?: Record<string, string>;
  choices?: { title: string; at: number[] }[];
  anyOf?: FieldSchema[];
};
export type ConfigSchema = {
  title: string;
  description: string;
  in_use: string;
  facts?: { needs: string; costs: string; takes: string };
  properties: Record<string, FieldSchema>;
};
export type ShirtKind = Omit<ShirtKindView, "form"> & { form: ConfigSchema };

export type Equipment = Omit<EquipmentView, "shirt" | "body" | "head"> & {
  shirt: ShirtConfig | null;
  body: BodyConfig | null;
  head: { config: HeadConfig | null; message: string };
};

/** What an adaptation changed of one joint. */
export type JointDifference = {
  angle_applied_deg?: number;
  dead_zone_before?: number;
  dead_zone_after?: number;
  full_before?: number;
  full_after?: number;
  range_moved?: boolean;
};

export type MapDifference = {
  by_itself?: boolean;
  back_to?: number;
  felt_change?: number;
  joints?: Record<string, JointDifference>;
};

export type MapVersion = Omit<MapView, "difference"> & { difference: MapDifference | null };

export type CurveForm = "exponential" | "power" | "level";

/** A fitted curve with its 95 % band; a level line has no points. `aicc_more`: how much worse than the best it describes. */
export type CurveModel = {
  form: CurveForm | null;
  aicc_more: number;
  n?: number[];
  value?: number[];
  low?: number[];
  high?: number[];
};

/** One measure over trials, in sentences and as curves. */
export type LearningCurve = {
  /** What became of it, in plain words. */
  text: string;
  /** What was kept from one session to the next, in plain words. */
  sessions: string | null;
  /** The statistics behind these sentences. */
  details: string[];
  fit: { n: number[]; value: number[]; low: number[]; high: number[] } | null;
  form: CurveForm | null;
  others: CurveModel[];
};

/** A trial that counts, with its measures by name. */
export type LearningTrial = {
  number: number;
  id: number;
  session: number;
  /** ISO 8601. */
  started: string;
  /** One of the first three trials of the task on its day: not compared. */
  familiarisation: boolean;
  profile_version: number;
  origin: string;
  simulated: boolean | null;
  source: string;
  [measure: string]: unknown;
};

export type Learning = Omit<LearningView, "trials" | "curves"> & {
  trials: LearningTrial[];
  curves: Record<string, LearningCurve | undefined>;
};
