export type { Basins } from "./basins";
export type * from "./catalogue";
export { type BasinsOptions, Core, type EnsembleOptions, type Progress, type Starts } from "./core";
export type { Ensemble } from "./ensemble";
export { CoreBroken, CoreError } from "./error";
export type * from "./report";
export type { Run, RunEvent } from "./run";
export type { Table } from "./table";
export { type Axis, type Part, place, tiles } from "./tiles";
