// The part of the plane that a picture shows, and what is done with it: places, zooms, moves.

export type Pair = readonly [number, number];

export interface Window {
  centre: Pair;
  /** How far it reaches to each side. */
  half: Pair;
}

/** No closer than this to the whole: doubles end somewhere. */
const CLOSEST = 1e-9;

const both = (f: (k: 0 | 1) => number): Pair => [f(0), f(1)];

/** Where a place lies, as shares of the width from the left and of the height from the top. */
export const shareOf = ({ centre, half }: Window, at: Pair): Pair => [
  0.5 + (at[0] - centre[0]) / half[0] / 2,
  0.5 - (at[1] - centre[1]) / half[1] / 2,
];

/** The place at such shares, to a thousandth of the window: nobody points finer. */
export const placeAt = (window: Window, [across, down]: Pair): Pair =>
  tidy(window, [
    window.centre[0] + (2 * across - 1) * window.half[0],
    window.centre[1] + (1 - 2 * down) * window.half[1],
  ]);

/** A place in as few digits as the window shows. */
export function tidy({ half }: Window, at: Pair): Pair {
  return both((k) => {
    const digits = Math.ceil(3 - Math.log10(half[k]));
    const step = 10 ** -digits;
    return Number((Math.round(at[k] / step) * step).toFixed(Math.min(Math.max(digits, 0), 20)));
  });
}

/** Within the window. */
export const inside = ({ centre, half }: Window, at: Pair): Pair =>
  both((k) => Math.min(Math.max(at[k], centre[k] - half[k]), centre[k] + half[k]));

/** So many times as close about a place, which stays where it is; never closer than doubles can tell. */
export function zoomed(window: Window, times: number, about: Pair, whole: Window): Window {
  const least = both((k) => CLOSEST * Math.max(whole.half[k], Math.abs(about[k])));
  const share = Math.max(1 / times, ...both((k) => Math.min(least[k] / window.half[k], 1)));
  return {
    centre: both((k) => about[k] + (window.centre[k] - about[k]) * share),
    half: both((k) => window.half[k] * share),
  };
}

/** Moved by some of its halves. */
export const moved = ({ centre, half }: Window, by: Pair): Window => ({
  centre: both((k) => centre[k] + by[k] * half[k]),
  half,
});

/** The part of a window between two places, of the window's shape. */
export function between(window: Window, a: Pair, b: Pair, whole: Window): Window {
  const share = Math.max(...both((k) => Math.abs(a[k] - b[k]) / 2 / window.half[k]));
  const middle = both((k) => (a[k] + b[k]) / 2);
  return { ...zoomed(window, 1 / share, middle, whole), centre: middle };
}
