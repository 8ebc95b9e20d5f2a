import type { BasinsReport } from "./report";
import { Result } from "./result";

/** What a label says where it is no attractor's number. */
export const UNDECIDED = -1;
export const ESCAPED = -2;
export const DIVERGED = -3;

/** Where the starts of a tile end, from `Core.basins`. */
export class Basins extends Result<BasinsReport> {
  /** The number of each start's attractor in `report.attractors`, or a negative one; a copy that stays. */
  get labels(): Float64Array {
    return this.table("numbers").slice();
  }
}
