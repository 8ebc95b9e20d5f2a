// A ball on a hill: a particle on a line, shown on the graph of its potential, with its energy as a level above it.

import type { Look } from "../../lab/result";
import type { Point } from "./pen";
import type { Flat } from "./scene";

/** The height of the hill at a place, in the units of the column `potential`: a test holds the two together. */
export type Height = (look: Look) => (x: number) => number;

/** At least from `-nearest` to `nearest` is seen, and never more than to `widest`. */
export function landscape(height: Height, nearest = 0, widest = Infinity): Flat {
  const reach = (look: Look) => Math.min(Math.max(look.reach("x") * 1.35, nearest), widest) || 1;
  /** Where the lowest lies, and how large a unit of energy is drawn: valleys, hills and the energy are all seen. */
  const view = (look: Look) => {
    const [u, half] = [height(look), reach(look)];
    const grid = Array.from({ length: 201 }, (_, k) => u(half * (k / 100 - 1)));
    const turns = grid.filter((y, k) => (y - (grid[k - 1] ?? y)) * (y - (grid[k + 1] ?? y)) > 0);
    const energies = look.column("energy").filter((_, k) => Math.abs(look.at("x", k)) <= half);
    const low = Math.min(...turns, u(0));
    const high = Math.max(...turns, ...energies);
    return { u, half, low, scale: half / (high - low || 1) };
  };
  return {
    kind: "flat",
    reach: (look) => [reach(look), 0.75 * reach(look)],
    draw(pen, look, sample) {
      const { u, half, low, scale } = view(look);
      const y = (energy: number) => (energy - low) * scale - 0.5 * half;
      const across = Math.min(pen.half, 3 * half);
      const curve = Array.from({ length: 241 }, (_, k): Point => {
        const x = across * (k / 120 - 1);
        return [x, Math.min(Math.max(y(u(x)), -4 * half), 4 * half)];
      });
      pen.area([...curve, [across, -2 * half], [-across, -2 * half]], pen.ink.faint, 0.16);
      pen.line(curve, 2.2);
      const [x, energy] = [look.at("x", sample), y(look.at("energy", sample))];
      pen.line(
        [
          [-across, energy],
          [across, energy],
        ],
        1,
        pen.ink.faint,
        [6, 5],
      );
      // What is missing to the level is its motion.
      pen.line(
        [
          [x, y(u(x))],
          [x, energy],
        ],
        2,
        pen.ink.accent,
      );
      pen.ball(x, y(u(x)) + 0.02 * half, 11, pen.ink.accent);
    },
    drag: (_look, _sample, x) => ({ x, x_dot: 0 }),
  };
}

/** A polynomial, the constant first. */
export function polynomial(coefficients: readonly number[]): (x: number) => number {
  return (x) => coefficients.reduceRight((sum, c) => sum * x + c, 0);
}
