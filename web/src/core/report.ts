// What the core says of a result beside its numbers (crates/wasm/src/report.rs).

import type { Text } from "./catalogue";

export interface Column {
  name: string;
  /** Empty for a pure number. */
  unit: string;
  kind: "time" | "state" | "signal" | "invariant";
}

/** How far an invariant has moved; null where a number is not finite, and `relative` where the start is zero. */
export interface Drift {
  name: string;
  unit: string;
  start: number | null;
  largest: number | null;
  relative: number | null;
}

export interface TableReport {
  rows: number;
  columns: Column[];
  /** Why the work ended before its time, in a sentence; what is there is right. */
  failure: string | null;
}

export interface Report extends TableReport {
  /** Names of the events that were met. */
  events: string[];
  /** What the system says of each; null for one that the scenario watches. */
  event_texts: (Text | null)[];
  drifts: Drift[];
  /** The watched event that ended the run. */
  stopped_by: string | null;
  version: string;
  /** The scenario (TOML) with everything spelt out, and its SHA-256. */
  scenario: string;
  scenario_hash: string;
  steps: number;
  rejections: number;
  evaluations: number;
}

export interface EnsembleReport {
  members: number;
  /** The numbers of a state: coordinates, velocities. */
  columns: Pick<Column, "name" | "unit">[];
  /** How many members ended before their time. */
  failed: number;
  version: string;
  /** The scenario (TOML) that the members have in common, with everything spelt out. */
  scenario: string;
}

export interface BasinsReport {
  /** How many starts there are. */
  rows: number;
  /** The numbers of a state: coordinates, velocities. */
  columns: Pick<Column, "name" | "unit">[];
  /** The attractors that labels number, by their states. */
  attractors: number[][];
}
