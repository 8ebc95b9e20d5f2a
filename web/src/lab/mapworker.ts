/// <reference lib="webworker" />
// A thread that computes tiles of a map: where runs from many starts end.

import { Core, type Axis } from "../core";

export interface TileAsk {
  module: WebAssembly.Module;
  round: number;
  text: string;
  tile: Axis[];
  column: string;
}
export interface TileAnswer {
  round: number;
  tile: Axis[];
  values: Float64Array;
  refusal: string;
}

let core: Promise<Core> | undefined;

addEventListener("message", ({ data }: MessageEvent<TileAsk>) => {
  core ??= Core.load(data.module);
  void core.then((ready) => {
    postMessage(compute(ready, data));
  });
});

function compute(core: Core, { round, text, tile, column }: TileAsk): TileAnswer {
  try {
    const part = core.ensemble(text, tile);
    const values = part.column(column);
    part.free();
    return { round, tile, values, refusal: "" };
  } catch (error) {
    const refusal = error instanceof Error ? error.message : String(error);
    return { round, tile, values: new Float64Array(0), refusal };
  }
}
