import { TABLES } from "./exports";
import type { Instance } from "./instance";

/** A result: its numbers stay in the core's memory until `free`. */
export abstract class Result<Report> {
  readonly report: Report;
  readonly #core: Instance;
  readonly #handle: number;
  #freed = false;

  constructor(core: Instance, handle: number, report: Report) {
    this.#core = core;
    this.#handle = handle;
    this.report = report;
  }

  /** Gives the memory back; nothing but the report can be asked for afterwards. Twice is once. */
  free(): void {
    if (this.#freed) return;
    this.#freed = true;
    this.#core.exports.precess_free(this.#handle);
  }

  /** A table in place; the next call of the core may move it. */
  protected table(name: keyof typeof TABLES): Float64Array {
    const core = this.#alive();
    const { precess_table, precess_table_length } = core.exports;
    const which = TABLES[name];
    return core.view(precess_table(this.#handle, which), precess_table_length(this.#handle, which));
  }

  /** The SHA-256 of a member, the one that `precess run --hash` prints for it. */
  protected hashOf(member: number): string {
    return this.#alive().ask((exports) => exports.precess_hash(this.#handle, member)).answer;
  }

  /** Why a member ended before its time. */
  protected failureOf(member: number): string {
    return this.#alive().ask((exports) => exports.precess_failure(this.#handle, member)).answer;
  }

  #alive(): Instance {
    if (this.#freed) throw new ReferenceError("this result has been freed");
    return this.#core;
  }
}
