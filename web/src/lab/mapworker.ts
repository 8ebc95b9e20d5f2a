/// <reference lib="webworker" />
// A thread that computes tiles of a map: where runs from many starts end, or are proved to end.

import { Core, type Axis } from "../core";

export interface TileAsk {
  module: WebAssembly.Module;
  round: number;
  text: string;
  tile: Axis[];
  wanted: Wanted;
  /** Whether labels that nothing confirms will do for now. */
  draft: boolean;
}
/** Columns of the states at the end of the run, or labels that are proved. */
export type Wanted = { columns: string[] } | "labels";
export interface TileAnswer {
  round: number;
  tile: Axis[];
  draft: boolean;
  /** A column each, of the states at the end; or the labels alone. */
  values: Float64Array[];
  /** What labels number. */
  attractors: Attractors;
  refusal: string;
}

/** States column by column, under their names. */
export interface Attractors {
  names: string[];
  states: Float64Array[];
}

let core: Promise<Core> | undefined;

addEventListener("message", ({ data }: MessageEvent<TileAsk>) => {
  core ??= Core.load(data.module);
  void core.then((ready) => {
    postMessage(compute(ready, data));
  });
});

function compute(core: Core, { round, text, tile, wanted, draft }: TileAsk): TileAnswer {
  const answer = { round, tile, draft, attractors: { names: [], states: [] }, refusal: "" };
  try {
    if (wanted === "labels") {
      const part = core.basins(text, tile, { draft });
      const { columns, attractors } = part.report;
      const names = columns.map(({ name }) => name);
      const states = names.map((_, k) => Float64Array.from(attractors, (state) => state[k] ?? NaN));
      const values = [part.labels];
      part.free();
      return { ...answer, values, attractors: { names, states } };
    }
    const part = core.ensemble(text, tile);
    const values = wanted.columns.map((column) => part.column(column));
    part.free();
    return { ...answer, values };
  } catch (error) {
    const refusal = error instanceof Error ? error.message : String(error);
    return { ...answer, values: [], refusal };
  }
}
