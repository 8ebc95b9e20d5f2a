import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.parameter("l1") + look.parameter("l2"),
  draw(pen, look, sample) {
    const at = (k: number, mass: number): [number, number] => [
      look.at(`x${mass}`, k),
      look.at(`y${mass}`, k),
    ];
    const size = (mass: number) => 12 * Math.cbrt(look.parameter(`m${mass}`) / look.parameter("m1"));
    pen.ceiling(look.parameter("l1") * 0.3, 0);
    pen.trail(
      look,
      (k) => look.at("x2", k),
      (k) => look.at("y2", k),
      sample,
    );
    pen.line([[0, 0], at(sample, 1), at(sample, 2)], 3);
    pen.ball(...at(sample, 1), 12);
    pen.ball(...at(sample, 2), Math.min(Math.max(size(2), 4), 30), pen.ink.accent);
  },
  drag(look, sample, x, y) {
    const [x1, y1] = [look.at("x1", sample), look.at("y1", sample)];
    const upper =
      Math.hypot(x - x1, y - y1) > Math.hypot(x - look.at("x2", sample), y - look.at("y2", sample));
    const lower = { theta2: Math.atan2(x - x1, y1 - y), theta2_dot: 0 };
    return upper ? lower : { theta1: Math.atan2(x, -y), theta1_dot: 0 };
  },
};
export default scene;
