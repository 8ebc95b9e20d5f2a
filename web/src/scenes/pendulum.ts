import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.parameter("l"),
  draw(pen, look, sample) {
    const l = look.parameter("l");
    const at = (k: number): [number, number] => {
      const theta = look.at("theta", k);
      return [l * Math.sin(theta), -l * Math.cos(theta)];
    };
    pen.line(
      [
        [0, 0],
        [0, -l * 1.05],
      ],
      0.8,
      pen.ink.faint,
      [2, 4],
    );
    pen.ceiling(l * 0.22, 0);
    pen.trail(
      look,
      (k) => at(k)[0],
      (k) => at(k)[1],
      sample,
    );
    pen.line([[0, 0], at(sample)], 3);
    pen.ball(...at(sample), 14);
  },
  drag: (_look, _sample, x, y) => ({ theta: Math.atan2(x, -y), theta_dot: 0 }),
};
export default scene;
