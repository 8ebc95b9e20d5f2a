import type { TableReport } from "./report";
import { Result } from "./result";

/** A table of numbers: a run, or what an analysis gives. */
export class Table<Report extends TableReport = TableReport> extends Result<Report> {
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
    if (at < 0) throw new RangeError(`there is no column ${name}`);
    const numbers = this.numbers;
    return Float64Array.from({ length: this.report.rows }, (_, row) => numbers[row * width + at] ?? NaN);
  }
}
