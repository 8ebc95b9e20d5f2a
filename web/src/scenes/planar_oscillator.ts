import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.reach("x", "y"),
  draw(pen, look, sample) {
    pen.cross(look.reach("x", "y"), 0.8, [2, 4]);
    pen.bob(look, sample, 12, 1.2);
  },
  drag: (_look, _sample, x, y) => ({ x, y, x_dot: 0, y_dot: 0 }),
};
export default scene;
