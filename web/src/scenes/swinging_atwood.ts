import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const reach = (look: Look) => look.reach("r") || 1;

const scene: Flat = {
  kind: "flat",
  reach: (look) => 1.25 * reach(look),
  centre: (look) => [-0.3 * reach(look), -0.1 * reach(look)],
  draw(pen, look, sample) {
    const r = reach(look);
    const wheel = 0.07 * r;
    const left = -1.2 * r;
    const mass: Point = [look.at("px", sample), look.at("py", sample)];
    // The string keeps its length: what the swing takes, the heavy side gives.
    const heavy: Point = [left - wheel, -(1.25 * r - look.at("r", sample)) - 0.1 * r];
    pen.path(look, "px", "py", sample);
    pen.line(
      [
        [left, wheel],
        [0, wheel],
      ],
      1.6,
    );
    pen.line([[left - wheel, 0], heavy], 1.6);
    pen.line([[0, 0], mass], 1.6);
    for (const x of [left, 0]) {
      pen.circle(x, 0, wheel, pen.ink.ink, 3);
      pen.ball(x, 0, 3);
    }
    pen.box(heavy[0], heavy[1], 0.09 * r * Math.cbrt(look.parameter("mu")) * 0.8, 1);
    pen.ball(...mass, 11, pen.ink.accent);
  },
  drag: (_look, _sample, x, y) => ({ r: Math.hypot(x, y), theta: Math.atan2(x, -y), r_dot: 0, theta_dot: 0 }),
};
export default scene;
