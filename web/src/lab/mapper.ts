// Computes a map in several workers, coarse first; a newer map takes the place of the one in progress.

import { tiles, type Axis } from "../core";
import plainUrl from "../../wasm/precess.wasm?url";
import lanesUrl from "../../wasm/precess-simd128.wasm?url";
import type { TileAnswer, TileAsk } from "./mapworker";

/** The smallest module with a 128-bit number in it. */
const SIMD = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98,
  11,
]);
/** Points along the edge of a tile: small enough for a tile that nobody wants any more to end soon. */
const EDGE = 16;

export class Mapper {
  readonly #module: WebAssembly.Module;
  readonly #workers: Worker[];
  readonly #idle: Worker[];
  #queue: Iterator<Axis[]> | undefined;
  #round = 0;
  #text = "";
  #column = "";
  #told: (answer: TileAnswer) => void = () => undefined;

  private constructor(module: WebAssembly.Module, workers: number) {
    this.#module = module;
    this.#workers = Array.from({ length: workers }, () => {
      const worker = new Worker(new URL("./mapworker.ts", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }: MessageEvent<TileAnswer>) => {
        if (data.round === this.#round) this.#told(data);
        this.#idle.push(worker);
        this.#spread();
      };
      return worker;
    });
    this.#idle = [...this.#workers];
  }

  /** The core with lanes is loaded here, when a map is wanted. */
  static async open(): Promise<Mapper> {
    const url = WebAssembly.validate(SIMD) ? lanesUrl : plainUrl;
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    const module = await WebAssembly.compile(await response.arrayBuffer());
    return new Mapper(module, Math.min(Math.max(navigator.hardwareConcurrency - 1, 1), 8));
  }

  /** Asks for a column of the last state over a grid of starts; `told` hears each tile as it is done. */
  compute(text: string, axes: Axis[], column: string, told: (answer: TileAnswer) => void): void {
    this.#round++;
    [this.#text, this.#column, this.#told] = [text, column, told];
    this.#queue = tiles(axes, 8, EDGE);
    this.#spread();
  }

  #spread(): void {
    while (this.#queue && this.#idle.length > 0) {
      const next = this.#queue.next();
      if (next.done) {
        this.#queue = undefined;
        return;
      }
      const ask: TileAsk = {
        module: this.#module,
        round: this.#round,
        text: this.#text,
        tile: next.value,
        column: this.#column,
      };
      this.#idle.pop()?.postMessage(ask);
    }
  }

  close(): void {
    for (const worker of this.#workers) worker.terminate();
  }
}
