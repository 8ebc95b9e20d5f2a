// What the core gives and takes, as in crates/wasm/src/exports.rs. Nothing outside this folder sees it.

/** Told now and then how far the work has come (a run's time, an ensemble's members); not zero ends it. */
export type HostProgress = (done: number) => number;

/** The tables of a result, as numbered in crates/wasm/src/kept.rs. */
export const TABLES = { numbers: 0, events: 1, times: 2, failed: 3 } as const;

export interface CoreExports {
  readonly memory: WebAssembly.Memory;
  readonly precess_input: (bytes: number) => number;
  readonly precess_answer: () => number;
  readonly precess_answer_bytes: () => number;
  readonly precess_catalogue: () => void;
  readonly precess_run: () => number;
  readonly precess_ensemble: (grid: number, samples: number, plain: number) => number;
  readonly precess_basins: (draft: number, plain: number) => number;
  readonly precess_trust: (within: number) => number;
  readonly precess_table: (handle: number, table: number) => number;
  readonly precess_table_length: (handle: number, table: number) => number;
  readonly precess_hash: (handle: number, member: number) => number;
  readonly precess_failure: (handle: number, member: number) => number;
  readonly precess_free: (handle: number) => void;
  readonly precess_used: () => number;
}

const NAMES = [
  "precess_input",
  "precess_answer",
  "precess_answer_bytes",
  "precess_catalogue",
  "precess_run",
  "precess_ensemble",
  "precess_basins",
  "precess_trust",
  "precess_table",
  "precess_table_length",
  "precess_hash",
  "precess_failure",
  "precess_free",
  "precess_used",
] as const satisfies Exclude<keyof CoreExports, "memory">[];

/** Makes an instance; a module that is not this core is refused. */
export async function instantiate(
  source: BufferSource | WebAssembly.Module,
  progress: HostProgress,
): Promise<CoreExports> {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  const instance = await WebAssembly.instantiate(module, { precess: { progress } });
  const missing = NAMES.find((name) => typeof instance.exports[name] !== "function");
  if (missing !== undefined || !(instance.exports["memory"] instanceof WebAssembly.Memory)) {
    throw new TypeError(`this module is no Precess core: it lacks ${missing ?? "memory"}`);
  }
  return instance.exports as unknown as CoreExports;
}
