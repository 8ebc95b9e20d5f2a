import type { Look } from "../lab/result";
import type { Flat } from "./kit/scene";

const reach = (look: Look) => look.reach("x") || 1;

/** A pendulum with small swings, its pivot shaken up and down; the shaking is drawn larger than it is. */
const scene: Flat = {
  kind: "flat",
  reach: (look) => 1.7 * reach(look),
  draw(pen, look, sample) {
    const r = reach(look);
    const length = 2.6 * r;
    const x = look.at("x", sample);
    const pivot = 1.3 * r + 0.25 * r * (look.at("shake", sample) / (look.reach("shake") || 1));
    pen.line(
      [
        [0, 1.75 * r],
        [0, 0.85 * r],
      ],
      5,
      pen.ink.grid,
    );
    pen.line(
      [
        [0, pivot],
        [0, pivot - 1.08 * length],
      ],
      0.8,
      pen.ink.faint,
      [2, 4],
    );
    const y = pivot - Math.sqrt(Math.max(length ** 2 - x ** 2, 0));
    pen.line(
      [
        [0, pivot],
        [x, y],
      ],
      3,
    );
    pen.area([
      [-0.12 * r, pivot - 0.06 * r],
      [0.12 * r, pivot - 0.06 * r],
      [0.12 * r, pivot + 0.06 * r],
      [-0.12 * r, pivot + 0.06 * r],
    ]);
    pen.ball(x, y, 14, pen.ink.accent);
  },
  drag: (_look, _sample, x) => ({ x, x_dot: 0 }),
};
export default scene;
