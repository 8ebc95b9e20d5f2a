import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

/** Where the pivots hang, in lengths of the pendulums. */
const APART = 0.9;
const at = (look: Look, k: number, side: 1 | 2): Point => {
  const [l, theta] = [look.parameter("l"), look.at(`theta${side}`, k)];
  return [l * ((side === 1 ? -0.5 : 0.5) * APART + Math.sin(theta)), -l * Math.cos(theta)];
};

const scene: Flat = {
  kind: "flat",
  reach: (look) => 0.78 * look.parameter("l"),
  centre: (look) => [0, -0.52 * look.parameter("l")],
  draw(pen, look, sample) {
    const l = look.parameter("l");
    const [left, right] = [at(look, sample, 1), at(look, sample, 2)];
    pen.ceiling(0.75 * l, 0);
    // The spring joins the rods half way down.
    const half = (mass: Point, pivot: number): Point => [(mass[0] + pivot) / 2, mass[1] / 2];
    const [a, b] = [(-APART / 2) * l, (APART / 2) * l];
    pen.spring(half(left, a), half(right, b), 0.025 * l, 14);
    pen.line([[a, 0], left], 3);
    pen.line([[b, 0], right], 3);
    pen.ball(...left, 15, pen.ink.curves[0]);
    pen.ball(...right, 15, pen.ink.curves[1]);
  },
  drag(look, _sample, x, y) {
    const side = x < 0 ? 1 : 2;
    const pivot = (side === 1 ? -0.5 : 0.5) * APART * look.parameter("l");
    return { [`theta${side}`]: Math.atan2(x - pivot, -y), [`theta${side}_dot`]: 0 };
  },
};
export default scene;
