import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.reach("x", "y"),
  draw(pen, look, sample) {
    const reach = scene.reach(look);
    pen.line(
      [
        [-reach, 0],
        [reach, 0],
      ],
      0.8,
      pen.ink.faint,
      [2, 4],
    );
    pen.line(
      [
        [0, -reach],
        [0, reach],
      ],
      0.8,
      pen.ink.faint,
      [2, 4],
    );
    pen.trail(
      look,
      (k) => look.at("x", k),
      (k) => look.at("y", k),
      sample,
    );
    pen.line(
      [
        [0, 0],
        [look.at("x", sample), look.at("y", sample)],
      ],
      1.2,
    );
    pen.ball(look.at("x", sample), look.at("y", sample), 12);
  },
  drag: (_look, _sample, x, y) => ({ x, y, x_dot: 0, y_dot: 0 }),
};
export default scene;
