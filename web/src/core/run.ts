import type { Instance } from "./instance";
import type { Report } from "./report";

/** An event that was met, with the state (coordinates, velocities) there, before any jump. */
export interface RunEvent {
  name: string;
  t: number;
  state: Float64Array;
}

/** A run: its numbers stay in the core's memory until `free`. */
export class Run {
  readonly report: Report;
  readonly #core: Instance;
  readonly #handle: number;
  #freed = false;

  /** Runs come from `Core.run`. */
  constructor(core: Instance, handle: number, report: Report) {
    this.#core = core;
    this.#handle = handle;
    this.report = report;
  }

  /**
   * The numbers in place, row by row: `report.rows` rows of `report.columns.length`. The next call of the core may
   * move its memory, which empties the view: look at once, or copy.
   */
  get numbers(): Float64Array {
    const { exports } = this.#alive();
    return this.#core.view(
      exports.precess_numbers(this.#handle),
      exports.precess_numbers_length(this.#handle),
    );
  }

  /** A column by its name, as a copy that stays. */
  column(name: string): Float64Array {
    const width = this.report.columns.length;
    const at = this.report.columns.findIndex((column) => column.name === name);
    if (at < 0) throw new RangeError(`this run has no column ${name}`);
    const numbers = this.numbers;
    return Float64Array.from({ length: this.report.rows }, (_, row) => numbers[row * width + at] ?? NaN);
  }

  /** The events in the order of the integration, as copies that stay. */
  events(): RunEvent[] {
    const { exports } = this.#alive();
    const rows = this.#core.view(
      exports.precess_events(this.#handle),
      exports.precess_events_length(this.#handle),
    );
    const width = 2 + this.report.columns.filter((column) => column.kind === "state").length;
    return Array.from({ length: rows.length / width }, (_, row) => {
      const [which = NaN, t = NaN, ...state] = rows.subarray(row * width, (row + 1) * width);
      return { name: this.report.events[which] ?? "", t, state: Float64Array.from(state) };
    });
  }

  /** The SHA-256 of time and state, the one that `precess run --hash` prints. */
  hash(): string {
    return this.#alive().ask((exports) => exports.precess_hash(this.#handle)).answer;
  }

  /** Gives the memory back; nothing but the report can be asked for afterwards. Twice is once. */
  free(): void {
    if (this.#freed) return;
    this.#freed = true;
    this.#core.exports.precess_free(this.#handle);
  }

  #alive(): Instance {
    if (this.#freed) throw new ReferenceError("this run has been freed");
    return this.#core;
  }
}
