// What the page and its worker say to each other.

import type { Catalogue, Report, RunEvent } from "../core";

export type Ask = { kind: "open"; module: WebAssembly.Module } | { kind: "run"; id: number; text: string };

export type Answer =
  | { kind: "catalogue"; catalogue: Catalogue }
  | { kind: "progress"; id: number; t: number }
  | { kind: "done"; id: number; report: Report; hash: string; events: RunEvent[]; numbers: Float64Array }
  | { kind: "refused"; id: number; broken: boolean; sentence: string };
