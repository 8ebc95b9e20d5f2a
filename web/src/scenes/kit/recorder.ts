// A pen that writes a coordinate on paper: the paper runs down, so older is lower.

import type { Look } from "../../lab/result";
import type { Point, Pen } from "./pen";
import type { Flat } from "./scene";

/** What stands at the top of the paper, beside the pen. */
type Extra = (pen: Pen, look: Look, sample: number, reach: number, top: number) => void;

/** `window` is the share of the run that is on the paper. */
export function recorder(name: string, window = 0.15, extra: Extra = () => undefined): Flat {
  const reach = (look: Look) => look.reach(name) * 1.2 || 1;
  return {
    kind: "flat",
    reach,
    draw(pen, look, sample) {
      const r = reach(look);
      const top = 0.55 * r;
      const bottom = -1.1 * r;
      const length = Math.max(2, Math.round(look.times.length * window));
      for (const [x, width] of [
        [-r, 1.2],
        [0, 0.8],
        [r, 1.2],
      ] as const)
        pen.line(
          [
            [x, bottom],
            [x, top],
          ],
          width,
          pen.ink.grid,
        );
      const written: Point[] = [];
      for (let k = Math.max(0, sample - length); k <= sample; k++)
        written.push([look.at(name, k), top - ((sample - k) / length) * (top - bottom)]);
      pen.line(written, 1.8, pen.ink.accent);
      extra(pen, look, sample, r, top);
      pen.line(
        [
          [-1.1 * r, top],
          [1.1 * r, top],
        ],
        1.5,
      );
      pen.ball(look.at(name, sample), top, 11);
    },
    drag: (_look, _sample, x) => ({ [name]: x }),
  };
}
