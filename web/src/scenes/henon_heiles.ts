import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

/** The potential, as the column `potential` has it along the path. */
export function potential(look: Look): (x: number, y: number) => number {
  const lambda = look.parameter("lambda");
  return (x, y) => (x * x + y * y) / 2 + lambda * (x * x * y - y ** 3 / 3);
}

/** The line around the middle on which the potential has a value, or as far as it goes without meeting it. */
function level(u: (x: number, y: number) => number, value: number, far: number): Point[] {
  return Array.from({ length: 181 }, (_, k): Point => {
    const angle = (k * Math.PI) / 90;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    let r = 0;
    while (r < far && u(r * c, r * s) < value) r += far / 400;
    return [r * c, r * s];
  });
}

const scene: Flat = {
  kind: "flat",
  reach: (look) => Math.max(look.reach("x", "y"), 0.6) * 1.15,
  draw(pen, look, sample) {
    const u = potential(look);
    const far = 1.15 / (look.parameter("lambda") || 1);
    const energy = look.at("energy", sample);
    for (const share of [0.1, 0.3, 0.6]) pen.line(level(u, energy * share, far), 1, pen.ink.grid);
    pen.line(level(u, energy, far), 2);
    pen.path(look, "x", "y", sample);
    pen.ball(look.at("x", sample), look.at("y", sample), 8);
  },
  drag: (_look, _sample, x, y) => ({ x, y, x_dot: 0, y_dot: 0 }),
};
export default scene;
