import type { Report } from "./report";
import { Table } from "./table";

/** An event that was met, with the state (coordinates, velocities) there, before any jump. */
export interface RunEvent {
  name: string;
  t: number;
  state: Float64Array;
}

/** A run, from `Core.run`. */
export class Run extends Table<Report> {
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
