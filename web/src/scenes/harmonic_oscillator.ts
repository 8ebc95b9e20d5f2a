import type { Flat } from "./kit/scene";

const COILS = 12;

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.reach("x") * 1.3,
  draw(pen, look, sample) {
    const reach = look.reach("x") || 1;
    const x = look.at("x", sample);
    const wall = -1.45 * reach;
    const end = x - 0.1 * reach;
    const coil = (k: number): [number, number] => [
      wall + ((end - wall) * (k + 0.5)) / (2 * COILS),
      (k % 2 ? 0.09 : -0.09) * reach,
    ];
    pen.line(
      [
        [wall, -0.3 * reach],
        [wall, 0.3 * reach],
      ],
      2,
    );
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
    pen.line([[wall, 0], ...Array.from({ length: 2 * COILS }, (_, k) => coil(k)), [end, 0]], 1.6);
    pen.box(x, 0, 0.14 * reach, 1);
  },
  drag: (_look, _sample, x) => ({ x, x_dot: 0 }),
};
export default scene;
