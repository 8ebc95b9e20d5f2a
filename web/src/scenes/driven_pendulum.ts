import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: () => 1.1,
  draw(pen, look, sample) {
    const theta = look.at("theta", sample);
    pen.circle(0, 0, 1, pen.ink.grid);
    pen.line(
      [
        [0, 0],
        [0, -1.05],
      ],
      0.8,
      pen.ink.faint,
      [2, 4],
    );
    pen.trail(
      look,
      (k) => Math.sin(look.at("theta", k)),
      (k) => -Math.cos(look.at("theta", k)),
      sample,
    );
    pen.line(
      [
        [0, 0],
        [Math.sin(theta), -Math.cos(theta)],
      ],
      3,
    );
    // A positive torque turns the way the angle grows: from below to the right.
    const torque = look.at("drive", sample) / (look.reach("drive") || 1);
    pen.turning([0, 0], 0.34, Math.PI, -2.4 * torque, pen.ink.curves[0]);
    pen.ball(0, 0, 5);
    pen.ball(Math.sin(theta), -Math.cos(theta), 14, pen.ink.accent);
  },
  drag: (_look, _sample, x, y) => ({ theta: Math.atan2(x, -y), theta_dot: 0 }),
};
export default scene;
