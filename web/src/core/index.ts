export type * from "./catalogue";
export { Core, type Progress } from "./core";
export { CoreBroken, CoreError } from "./error";
export type * from "./report";
export type { Run, RunEvent } from "./run";
