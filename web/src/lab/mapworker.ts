/// <reference lib="webworker" />
// A thread that computes tiles of a map: where runs from many starts end.

import { Core, type Axis } from "../core";

export interface TileAsk {
  module: WebAssembly.Module;
  round: number;
  text: string;
  tile: Axis[];
  columns: string[];
}
export interface TileAnswer {
  round: number;
  tile: Axis[];
  /** A column each, of the states at the end. */
  values: Float64Array[];
  refusal: string;
}

let core: Promise<Core> | undefined;

addEventListener("message", ({ data }: MessageEvent<TileAsk>) => {
  core ??= Core.load(data.module);
  void core.then((ready) => {
    postMessage(compute(ready, data));
  });
});

function compute(core: Core, { round, text, tile, columns }: TileAsk): TileAnswer {
  try {
    const part = core.ensemble(text, tile);
    const values = columns.map((column) => part.column(column));
    part.free();
    return { round, tile, values, refusal: "" };
  } catch (error) {
    const refusal = error instanceof Error ? error.message : String(error);
    return { round, tile, values: [], refusal };
  }
}
