import type { Flat } from "./kit/scene";

const BUCKETS = 16;

/** Buckets around the wheel, filled as the two harmonics say: a to the side, b at the top. */
const scene: Flat = {
  kind: "flat",
  reach: () => 1.35,
  draw(pen, look, sample) {
    const [theta, a, b] = [look.at("theta", sample), look.at("a", sample), look.at("b", sample)];
    const most = Math.max(look.reach("a"), look.reach("b")) * 1.2 || 1;
    for (const x of [-0.08, 0, 0.08])
      pen.line(
        [
          [x, 1.5],
          [x, 1.18],
        ],
        4,
        pen.ink.curves[0],
        [2, 5],
      );
    pen.line(
      [
        [-0.5, -1.35],
        [0, 0],
        [0.5, -1.35],
      ],
      3,
    );
    pen.circle(0, 0, 1, pen.ink.ink, 3);
    for (let k = 0; k < BUCKETS; k++) {
      // From the top, clockwise: a positive angle of the wheel turns that way.
      const angle = theta + (k * 2 * Math.PI) / BUCKETS;
      const [s, c] = [Math.sin(angle), Math.cos(angle)];
      pen.line(
        [
          [0, 0],
          [s, c],
        ],
        1,
        pen.ink.faint,
      );
      pen.box(s, c - 0.06, 0.1, 0.5 + (a * s + b * c) / (2 * most));
      pen.ball(s, c, k === 0 ? 6 : 3, k === 0 ? pen.ink.accent : pen.ink.ink);
    }
    // Where the water weighs.
    pen.arrow([0, 0], [a / most, b / most]);
    pen.ball(0, 0, 6);
  },
};
export default scene;
