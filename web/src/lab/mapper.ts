// Computes a map in several workers, coarse first; a newer map takes the place of the one in progress, as soon as that
// one can be recognized: a drag shows something all the time.

import { tiles, type Axis } from "../core";
import plainUrl from "../../wasm/precess.wasm?url";
import lanesUrl from "../../wasm/precess-simd128.wasm?url";
import type { TileAnswer, TileAsk, Wanted } from "./mapworker";

/** The smallest module with a 128-bit number in it. */
const SIMD = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98,
  11,
]);
/** Points along the edge of a tile: small enough for a tile that nobody wants any more to end soon. */
const EDGE = 8;
/** The same where labels are wanted: those take longer. */
const EDGE_OF_LABELS = 4;
/** Along an edge of the first picture, which is there at once, there are so many points at the least; */
const FIRST = 6;
/** in all there are so many in one that can be recognized. */
const COARSE = (2 * FIRST) ** 2;

const pointsOf = (tile: readonly Axis[]) =>
  tile.reduce((all, { points, part }) => all * (part?.points ?? points), 1);

/** A map that is wanted, over a grid of starts. */
export interface MapAsk {
  text: string;
  axes: Axis[];
  wanted: Wanted;
  /** Hears each tile as it is done. */
  told: (tile: TileAnswer) => void;
}

/** All tiles, coarse first; where labels are wanted, a draft of the coarse ones before. */
function* order({ axes, wanted }: MapAsk): Generator<Pick<TileAsk, "tile" | "draft">, void> {
  const points = Math.min(...axes.map((axis) => axis.points));
  const all = (edge: number) => tiles(axes, 2 ** Math.floor(Math.log2(points / FIRST)), edge);
  let drafted = wanted === "labels" ? 0 : COARSE;
  for (const tile of all(EDGE)) {
    if (drafted >= COARSE) break;
    drafted += pointsOf(tile);
    yield { tile, draft: true };
  }
  for (const tile of all(wanted === "labels" ? EDGE_OF_LABELS : EDGE)) yield { tile, draft: false };
}

export class Mapper {
  readonly #module: WebAssembly.Module;
  readonly #workers: Worker[];
  readonly #idle: Worker[];
  #queue: Iterator<Pick<TileAsk, "tile" | "draft">> | undefined;
  #round = 0;
  #now: MapAsk | undefined;
  /** The newest wish, while the one before is too coarse to be recognized. */
  #next: MapAsk | undefined;
  /** How many points it needs until then. */
  #wanting = 0;

  private constructor(module: WebAssembly.Module, workers: number) {
    this.#module = module;
    this.#workers = Array.from({ length: workers }, () => {
      const worker = new Worker(new URL("./mapworker.ts", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }: MessageEvent<TileAnswer>) => {
        this.#idle.push(worker);
        if (data.round === this.#round) {
          this.#wanting -= pointsOf(data.tile);
          this.#now?.told(data);
          if (this.#next) this.compute(this.#next);
        }
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

  compute(ask: MapAsk): void {
    this.#next = this.#wanting > 0 ? ask : undefined;
    if (this.#next) return;
    this.#round++;
    this.#now = ask;
    this.#wanting = COARSE;
    this.#queue = order(ask);
    this.#spread();
  }

  #spread(): void {
    while (this.#queue && this.#now && this.#idle.length > 0) {
      const next = this.#queue.next();
      if (next.done) {
        this.#queue = undefined;
        return;
      }
      const ask: TileAsk = {
        module: this.#module,
        round: this.#round,
        text: this.#now.text,
        ...next.value,
        wanted: this.#now.wanted,
      };
      this.#idle.pop()?.postMessage(ask);
    }
  }

  close(): void {
    for (const worker of this.#workers) worker.terminate();
  }
}
