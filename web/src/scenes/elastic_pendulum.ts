import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const reach = (look: Look) => look.reach("px", "py") || 1;

const scene: Flat = {
  kind: "flat",
  reach: (look) => 0.75 * reach(look),
  centre: (look) => [0, (Math.min(...look.column("py")) + Math.max(...look.column("py"), 0)) / 2],
  draw(pen, look, sample) {
    const r = reach(look);
    const mass: Point = [look.at("px", sample), look.at("py", sample)];
    pen.ceiling(0.22 * r, 0);
    pen.path(look, "px", "py", sample);
    pen.spring([0, 0], mass, 0.045 * r);
    pen.ball(...mass, 13, pen.ink.accent);
  },
  drag: (_look, _sample, x, y) => ({ l: Math.hypot(x, y), theta: Math.atan2(x, -y), l_dot: 0, theta_dot: 0 }),
};
export default scene;
