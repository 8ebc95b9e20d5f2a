import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => [look.reach("x") * 1.6, look.reach("x") * 0.6],
  draw(pen, look, sample) {
    const r = look.reach("x") || 1;
    const x = look.at("x", sample);
    const steady = look.at("steady", sample);
    pen.wall(0.3 * r, -1.5 * r);
    pen.line(
      [
        [-1.5 * r, -0.16 * r],
        [1.6 * r, -0.16 * r],
      ],
      1.2,
    );
    // As far as the steady oscillation goes.
    for (const edge of [-steady, steady])
      pen.line(
        [
          [edge, -0.3 * r],
          [edge, 0.3 * r],
        ],
        1.2,
        pen.ink.curves[0],
        [4, 4],
      );
    pen.spring([-1.5 * r, 0], [x - 0.14 * r, 0], 0.09 * r);
    pen.box(x, 0, 0.14 * r, 1);
    pen.arrow([x, 0.3 * r], [(0.7 * r * look.at("drive", sample)) / (look.reach("drive") || 1), 0]);
  },
  drag: (_look, _sample, x) => ({ x, x_dot: 0 }),
};
export default scene;
