// A grid of starts, whole or in tiles.

/** Evenly spaced starts of one quantity, both ends included. */
export interface Axis {
  /** Name of an initial value. */
  name: string;
  low: number;
  high: number;
  points: number;
  /** Of these points only `points`: number `first`, `first + stride` and so on. */
  part?: Part;
}

export interface Part {
  first: number;
  stride: number;
  points: number;
}

/**
 * Cuts a grid into tiles that together hold each start once: first every `coarsest`-th point (a power of two) along
 * each axis, then those in between, and so on down to the last. Workers may take them in turn. No tile has more than
 * `edge` points along an axis.
 */
export function* tiles(axes: readonly Axis[], coarsest = 8, edge = 64): Generator<Axis[], void> {
  yield* lattice(axes, () => ({ first: 0, stride: coarsest }), edge);
  for (let stride = coarsest; stride > 1; stride /= 2) {
    // The points half way from one to the next: along the first axis, the second, both, and so on.
    for (let among = 1; among < 2 ** axes.length; among++) {
      const shifted = (axis: number) => ((among >> axis) & 1) === 1;
      yield* lattice(axes, (axis) => ({ first: shifted(axis) ? stride / 2 : 0, stride }), edge);
    }
  }
}

/** Where a member of a tile stands in the whole grid: the number of its point along each axis. */
export function place(axes: readonly Axis[], member: number): number[] {
  let rest = member;
  return axes.map(({ points, part = { first: 0, stride: 1, points } }) => {
    const k = rest % part.points;
    rest = Math.floor(rest / part.points);
    return part.first + part.stride * k;
  });
}

/** The points of a lattice, in tiles; the first axis runs fastest. */
function* lattice(
  axes: readonly Axis[],
  of: (axis: number) => { first: number; stride: number },
  edge: number,
): Generator<Axis[], void> {
  const [axis, ...others] = [...axes].reverse();
  if (!axis) {
    yield [];
    return;
  }
  const { first, stride } = of(others.length);
  for (let from = first; from < axis.points; from += stride * edge) {
    const points = Math.min(edge, Math.ceil((axis.points - from) / stride));
    for (const rest of lattice(others.reverse(), of, edge)) {
      yield [...rest, { ...axis, part: { first: from, stride, points } }];
    }
  }
}
