// The part of the plane that a run needs: where some of its points go, with room around them.

import type { Look } from "../../lab/result";
import type { Point } from "./pen";

/** Of the points whose coordinates are the columns `x0`, `y0` ... of these numbers. */
export function frame(look: Look, bodies: readonly number[], room: number): { centre: Point; reach: Point } {
  const side = (axis: string): Point => {
    let [low, high] = [Infinity, -Infinity];
    for (const body of bodies)
      for (const x of look.column(`${axis}${body}`)) {
        if (x < low) low = x;
        if (x > high) high = x;
      }
    return [(low + high) / 2, (high - low) / 2];
  };
  const [[x, across], [y, up]] = [side("x"), side("y")];
  const more = room || 0.05 * Math.max(across, up) || 1;
  return { centre: [x, y], reach: [across + more, up + more] };
}
