import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => 1.15 * look.parameter("l") + look.parameter("a"),
  draw(pen, look, sample) {
    const [l, a, pivot] = [look.parameter("l"), look.parameter("a"), look.at("pivot", sample)];
    pen.line(
      [
        [0, -2 * a],
        [0, 2 * a],
      ],
      7,
      pen.ink.grid,
    );
    pen.circle(0, 0, l, pen.ink.grid);
    pen.path(look, "px", "py", sample);
    pen.line(
      [
        [0, pivot],
        [look.at("px", sample), look.at("py", sample)],
      ],
      3,
    );
    pen.area([
      [-0.07 * l, pivot - 0.03 * l],
      [0.07 * l, pivot - 0.03 * l],
      [0.07 * l, pivot + 0.03 * l],
      [-0.07 * l, pivot + 0.03 * l],
    ]);
    pen.ball(look.at("px", sample), look.at("py", sample), 13, pen.ink.accent);
  },
  drag: (_look, _sample, x, y) => ({ theta: Math.atan2(x, -y), theta_dot: 0 }),
};
export default scene;
