import type { Report } from "./report";
import { Result } from "./result";

/** An event that was met, with the state (coordinates, velocities) there, before any jump. */
export interface RunEvent {
  name: string;
  t: number;
  state: Float64Array;
}

/** A run, from `Core.run`. */
export class Run extends Result<Report> {
  /**
   * The numbers in place, row by row: `report.rows` rows of `report.columns.length`. The next call of the core may
   * move its memory, which empties the view: look at once, or copy.
   */
  get numbers(): Float64Array {
    return this.table("numbers");
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
    const rows = this.table("events");
    const width = 2 + this.report.columns.filter((column) => column.kind === "state").length;
    return Array.from({ length: rows.length / width }, (_, row) => {
      const [which = NaN, t = NaN, ...state] = rows.subarray(row * width, (row + 1) * width);
      return { name: this.report.events[which] ?? "", t, state: Float64Array.from(state) };
    });
  }

  /** The SHA-256 of time and state, the one that `precess run --hash` prints. */
  hash(): string {
    return this.hashOf(0);
  }
}
