// The picture of a map: its points as far as they are known, coarse first, and their colours and patterns.

import { place, type Axis } from "../core";

export type Rgb = readonly [red: number, green: number, blue: number];

/** What stands for a value: one of several kinds (a whole number), or a share of a range. */
export type Dye = { kinds: readonly Rgb[] } | { low: number; high: number };

/** From deep blue over paper to vermilion: its lightness alone tells the middle from the ends. */
const INKS: readonly Rgb[] = [
  [22, 48, 110],
  [110, 160, 205],
  [246, 240, 222],
  [232, 140, 80],
  [150, 30, 12],
];
/** A run that has failed. */
const NONE: Rgb = [128, 128, 128];
const BLANK = [0, 0, 0, 0] as const;

/** Pixels along a point of a patterned picture. */
export const CELL = 6;
/** Where a pattern has ink: each is denser than the one before, so that they tell a range as well as kinds. */
const PATTERNS: readonly ((x: number, y: number) => boolean)[] = [
  () => false,
  (x, y) => x % 12 < 3 && y % 12 < 3,
  (_x, y) => y % 9 < 2,
  (x, y) => (x + y) % 9 < 3,
  (x, y) => (x + y) % 8 < 2 || (x - y + 8_000) % 8 < 2,
];

export class Raster {
  readonly points: number;
  /** Row by row, the lowest first. */
  readonly #values: Float64Array;
  /** Over how many points a value reaches; its own has 1, one that is not known 0. */
  readonly #grain: Uint8Array;
  /** How many are known. */
  known = 0;
  /** How many have been taken, drafts included: the picture is another when they are more. */
  taken = 0;

  constructor(points: number) {
    this.points = points;
    this.#values = new Float64Array(points * points);
    this.#grain = new Uint8Array(points * points);
  }

  /** Takes the values of a tile of the map's two axes; a draft stands there until the values come. */
  take(tile: readonly Axis[], values: ArrayLike<number>, draft = false): void {
    const stride = tile[0]?.part?.stride ?? 1;
    const coarsest = tile.every(({ part }) => (part?.first ?? 0) % stride === 0);
    const size = coarsest ? stride : stride / 2;
    for (let member = 0; member < values.length; member++) {
      const [i = 0, j = 0] = place(tile, member);
      this.#fill(i, j, values[member] ?? NaN, size, draft);
    }
    this.taken += values.length;
    if (!draft) this.known += values.length;
  }

  /** A point stands for those about it until they come themselves. */
  #fill(i: number, j: number, value: number, size: number, draft: boolean): void {
    const { points } = this;
    for (let b = j; b < Math.min(j + size, points); b++) {
      for (let a = i; a < Math.min(i + size, points); a++) {
        const at = b * points + a;
        const own = !draft && a === i && b === j;
        const grain = this.#grain[at] ?? 0;
        if (!own && grain !== 0 && grain < size) continue;
        this.#values[at] = value;
        this.#grain[at] = own ? 1 : size;
      }
    }
  }

  /** The values themselves, without those that stand for others. */
  own(): Float64Array {
    return this.#values.filter((value, k) => this.#grain[k] === 1 && Number.isFinite(value));
  }

  /** The range without its outermost hundredths, which would take all colours for themselves. */
  range(): [number, number] {
    const own = this.own().sort();
    return [own[Math.floor(own.length * 0.01)] ?? 0, own[Math.ceil(own.length * 0.99) - 1] ?? 1];
  }

  /** Red, green, blue and opacity of `points * cell` pixels to each side, the highest row first. */
  pixels(dye: Dye, cell: number): Uint8ClampedArray<ArrayBuffer> {
    const { points } = this;
    const edge = points * cell;
    const pixels = new Uint8ClampedArray(4 * edge * edge);
    for (let y = 0; y < edge; y++) {
      const row = (points - 1 - Math.floor(y / cell)) * points;
      for (let i = 0; i < points; i++) {
        const [value, grain] = [this.#values[row + i] ?? NaN, this.#grain[row + i] ?? 0];
        const finite = Number.isFinite(value);
        const paint = grain === 0 ? BLANK : ([...(finite ? colourOf(dye, value) : NONE), 255] as const);
        const pattern = cell > 1 && finite && grain ? patternOf(dye, value) : undefined;
        for (let x = i * cell; x < (i + 1) * cell; x++)
          pixels.set(pattern?.(x, y) ? marked(paint) : paint, 4 * (y * edge + x));
      }
    }
    return pixels;
  }
}

const share = ({ low, high }: { low: number; high: number }, value: number) =>
  Math.min(Math.max((value - low) / (high - low || 1), 0), 1);

export function colourOf(dye: Dye, value: number): Rgb {
  if ("kinds" in dye) return dye.kinds[value % dye.kinds.length] ?? NONE;
  const part = share(dye, value) * 4;
  const k = Math.min(Math.floor(part), 3);
  const mix = (c: 0 | 1 | 2) => {
    const [a, b] = [INKS[k]?.[c] ?? 0, INKS[k + 1]?.[c] ?? 0];
    return Math.round(a + (b - a) * (part - k));
  };
  return [mix(0), mix(1), mix(2)];
}

/** Of a kind its own, of a range five that grow denser. */
export function patternOf(dye: Dye, value: number): (x: number, y: number) => boolean {
  const k = "kinds" in dye ? value : Math.min(Math.floor(share(dye, value) * 5), 4);
  return PATTERNS[k % PATTERNS.length] ?? (() => false);
}

/** A colour's mark: darker on what is light, lighter on what is dark. */
function marked([r, g, b]: readonly number[]): [number, number, number, number] {
  const light = 0.3 * (r ?? 0) + 0.6 * (g ?? 0) + 0.1 * (b ?? 0) > 110;
  const mix = (c = 0) => Math.round(light ? c * 0.3 : c + (255 - c) * 0.75);
  return [mix(r), mix(g), mix(b), 255];
}

/** `#1d3f7a` as numbers. */
export function rgb(hex: string): Rgb {
  const number = parseInt(hex.slice(1), 16);
  return [(number >> 16) & 255, (number >> 8) & 255, number & 255];
}
