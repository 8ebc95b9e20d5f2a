// What the page and its worker say to each other.

import type { Catalogue, Report, RunEvent } from "../core";

export type Ask =
  /** `stop` holds the number of the run that is to end, where page and worker may share memory. */
  | { kind: "open"; module: WebAssembly.Module; stop: Int32Array | undefined }
  | { kind: "run"; id: number; text: string };

export type Answer =
  | { kind: "catalogue"; catalogue: Catalogue }
  | { kind: "progress"; id: number; t: number }
  | { kind: "done"; id: number; report: Report; hash: string; events: RunEvent[]; numbers: Float64Array }
  | { kind: "refused"; id: number; broken: boolean; sentence: string };
