import type { Flat } from "./kit/scene";
import type { Point } from "./kit/pen";
import type { Look } from "../lab/result";

const size = (look: Look) => look.reach("length") || 1;
const hangs = (look: Look) => look.parameter("g") !== 0;

/** Along the spring, from its fixed end: sideways without weight, downwards with it. */
const at = (look: Look, length: number): Point => {
  const half = 0.6 * size(look);
  return hangs(look) ? [0, half - length] : [length - half, 0];
};

const scene: Flat = {
  kind: "flat",
  reach: (look) => (hangs(look) ? 0.72 * size(look) : [0.8 * size(look), 0.28 * size(look)]),
  draw(pen, look, sample) {
    const s = size(look);
    const [length, x] = [look.at("length", sample), look.at("x", sample)];
    const half = 0.07 * s;
    // The spring ends at the near side of the mass.
    const [side, mass] = [at(look, length), at(look, length + half)];
    const [rest, end] = [at(look, length - x + half), at(look, 0)];
    if (hangs(look)) {
      pen.ceiling(0.25 * s, end[1]);
      pen.line(
        [
          [-0.3 * s, rest[1]],
          [0.3 * s, rest[1]],
        ],
        1,
        pen.ink.faint,
        [4, 4],
      );
    } else {
      pen.wall(0.16 * s, end[0]);
      pen.line(
        [
          [end[0], -half],
          [0.7 * s, -half],
        ],
        1.2,
      );
      pen.line(
        [
          [rest[0], -half],
          [rest[0], -2 * half],
        ],
        1.2,
        pen.ink.faint,
      );
    }
    pen.spring(end, side, 0.05 * s);
    pen.box(...mass, half, 1);
    // The pull of the spring, to scale with its largest.
    const pull = look.at("force", sample) / (look.reach("force") || 1);
    pen.arrow(mass, hangs(look) ? [0, 0.25 * s * pull] : [-0.25 * s * pull, 0]);
  },
  drag(look, _sample, x, y) {
    const length = (hangs(look) ? at(look, 0)[1] - y : x - at(look, 0)[0]) - 0.07 * size(look);
    return { x: length - (look.at("length", 0) - look.at("x", 0)), x_dot: 0 };
  },
};
export default scene;
