// What the core gives and takes, as in crates/wasm/src/exports.rs. Nothing outside this folder sees it.

/** Called with the time that a run has reached, now and then; not zero ends the run. */
export type HostProgress = (t: number) => number;

export interface CoreExports {
  readonly memory: WebAssembly.Memory;
  readonly precess_input: (bytes: number) => number;
  readonly precess_answer: () => number;
  readonly precess_answer_bytes: () => number;
  readonly precess_catalogue: () => void;
  readonly precess_run: () => number;
  readonly precess_numbers: (handle: number) => number;
  readonly precess_numbers_length: (handle: number) => number;
  readonly precess_events: (handle: number) => number;
  readonly precess_events_length: (handle: number) => number;
  readonly precess_hash: (handle: number) => number;
  readonly precess_free: (handle: number) => void;
  readonly precess_used: () => number;
}

const NAMES = [
  "precess_input",
  "precess_answer",
  "precess_answer_bytes",
  "precess_catalogue",
  "precess_run",
  "precess_numbers",
  "precess_numbers_length",
  "precess_events",
  "precess_events_length",
  "precess_hash",
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
