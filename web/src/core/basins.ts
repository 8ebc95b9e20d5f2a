import type { BasinsReport } from "./report";
import { Result } from "./result";

/** Where the starts of a tile end, from `Core.basins`. */
export class Basins extends Result<BasinsReport> {
  /** The number of each start's attractor in `report.attractors`, or -1 where it is undecided, -2 where it has escaped,
   * -3 where it does not go on in numbers; a copy that stays. */
  get labels(): Float64Array {
    return this.table("numbers").slice();
  }
}
