import type { Flat } from "./kit/scene";

const BUCKETS = 8;

const scene: Flat = {
  kind: "flat",
  reach: () => 1.35,
  draw(pen, look, sample) {
    const theta = look.at("theta", sample);
    pen.line(
      [
        [0, 1.5],
        [0, 1.16],
      ],
      4,
      pen.ink.curves[0],
      [2, 5],
    );
    pen.line(
      [
        [0, 0],
        [-0.5, -1.35],
      ],
      3,
    );
    pen.line(
      [
        [0, 0],
        [0.5, -1.35],
      ],
      3,
    );
    pen.circle(0, 0, 1, pen.ink.ink, 3);
    pen.circle(0, 0, 0.1, pen.ink.ink, 3);
    for (let k = 0; k < BUCKETS; k++) {
      const angle = theta + (k * 2 * Math.PI) / BUCKETS;
      const [x, y] = [Math.sin(angle), -Math.cos(angle)];
      pen.line(
        [
          [0, 0],
          [x, y],
        ],
        1.5,
      );
      pen.box(x, y - 0.08, 0.13, look.at(`m${k}`, sample) / look.parameter("capacity"));
      pen.ball(x, y, k === 0 ? 6 : 4, k === 0 ? pen.ink.accent : pen.ink.ink);
    }
  },
};
export default scene;
