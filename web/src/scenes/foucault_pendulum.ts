import type { Look } from "../lab/result";
import type { Flat } from "./kit/scene";

const reach = (look: Look) => look.reach("x", "y") || 1;

/** From above, with the points of the compass. */
const scene: Flat = {
  kind: "flat",
  reach: (look) => 1.15 * reach(look),
  draw(pen, look, sample) {
    const r = reach(look);
    pen.circle(0, 0, 1.04 * r, pen.ink.ink, 1.5);
    for (let k = 0; k < 72; k++) {
      const [c, s] = [Math.cos((k * Math.PI) / 36), Math.sin((k * Math.PI) / 36)];
      const inner = k % 18 === 0 ? 0.96 : k % 6 === 0 ? 0.99 : 1.015;
      pen.line(
        [
          [inner * r * c, inner * r * s],
          [1.04 * r * c, 1.04 * r * s],
        ],
        k % 18 ? 0.8 : 1.6,
      );
    }
    pen.letter(0, 1.13 * r, "N");
    pen.letter(1.13 * r, 0, "E");
    pen.bob(look, sample, 11, 0.8, pen.ink.faint);
  },
  drag: (_look, _sample, x, y) => ({ x, y, x_dot: 0, y_dot: 0 }),
};
export default scene;
