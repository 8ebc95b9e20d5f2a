import type { EnsembleReport } from "./report";
import { Result } from "./result";

/** One scenario from many starts, from `Core.ensemble`. A member has the bits that it has when it runs alone. */
export class Ensemble extends Result<EnsembleReport> {
  /**
   * The states in place, member by member, at each of `times`: `report.columns.length` numbers each, NaN after a
   * failure. The next call of the core may move its memory, which empties the view: look at once, or copy.
   */
  get numbers(): Float64Array {
    return this.table("numbers");
  }

  /** The times of the states that are kept of each member, as a copy that stays. */
  get times(): Float64Array {
    return this.table("times").slice();
  }

  /** A quantity of every member at one of `times`, the last if not said otherwise; a copy that stays. */
  column(name: string, time = this.table("times").length - 1): Float64Array {
    const { columns, members } = this.report;
    const times = this.table("times").length;
    const at = columns.findIndex((column) => column.name === name);
    if (at < 0) throw new RangeError(`this ensemble has no column ${name}`);
    const numbers = this.numbers;
    const place = (member: number) => (member * times + time) * columns.length + at;
    return Float64Array.from({ length: members }, (_, member) => numbers[place(member)] ?? NaN);
  }

  /** The members that ended before their time, in order. */
  failed(): number[] {
    return [...this.table("failed")];
  }

  /** Why one of them did, in a sentence. */
  failure(member: number): string {
    return this.failureOf(member);
  }

  /**
   * The SHA-256 of a member's times and states; where every sample is kept, the one that `precess run --hash` prints
   * for that start alone.
   */
  hash(member: number): string {
    return this.hashOf(member);
  }
}
