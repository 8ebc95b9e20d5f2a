import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => [look.reach("x") * 1.5, look.reach("x") * 0.55],
  draw(pen, look, sample) {
    const reach = look.reach("x") || 1;
    const x = look.at("x", sample);
    const wall = -1.45 * reach;
    pen.wall(0.3 * reach, wall);
    pen.line(
      [
        [wall, -0.16 * reach],
        [1.5 * reach, -0.16 * reach],
      ],
      1.2,
    );
    pen.line(
      [
        [0, -0.16 * reach],
        [0, -0.24 * reach],
      ],
      1,
      pen.ink.faint,
    );
    pen.spring([wall, 0], [x - 0.14 * reach, 0], 0.09 * reach);
    pen.box(x, 0, 0.14 * reach, 1);
  },
  drag: (_look, _sample, x) => ({ x, x_dot: 0 }),
};
export default scene;
