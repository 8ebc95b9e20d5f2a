import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) =>
    Math.max(look.reach("x", "y"), ...look.list("magnets").map(([x = 0, y = 0]) => Math.hypot(x, y))),
  draw(pen, look, sample) {
    look.list("magnets").forEach(([x = 0, y = 0], k) => {
      const colour = pen.ink.curves[k % pen.ink.curves.length] ?? pen.ink.ink;
      pen.circle(x, y, 0.07, colour, 3);
      pen.ball(x, y, 5, colour);
    });
    pen.cross(0.03, 1);
    pen.bob(look, sample, 10, 0.8, pen.ink.faint);
  },
  places: ["x", "y"],
  drag: (_look, _sample, x, y) => ({ x, y, x_dot: 0, y_dot: 0 }),
};
export default scene;
