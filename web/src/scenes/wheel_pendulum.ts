import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const scene: Flat = {
  kind: "flat",
  reach: (look) => look.parameter("wheel") + look.parameter("l"),
  draw(pen, look, sample) {
    const wheel = look.parameter("wheel");
    const pivot: Point = [look.at("x_pivot", sample), look.at("y_pivot", sample)];
    pen.circle(0, 0, wheel, pen.ink.ink, 2.5);
    pen.circle(0, 0, 0.08 * wheel, pen.ink.ink, 2.5);
    for (let k = 0; k < 6; k++) {
      const [c, s] = [Math.cos((k * Math.PI) / 3), Math.sin((k * Math.PI) / 3)];
      pen.line(
        [
          [0, 0],
          [c * pivot[0] - s * pivot[1], s * pivot[0] + c * pivot[1]],
        ],
        1,
        pen.ink.faint,
      );
    }
    pen.path(look, "px", "py", sample);
    const mass: Point = [look.at("px", sample), look.at("py", sample)];
    pen.line([pivot, mass], 3);
    pen.ball(...pivot, 5);
    pen.ball(...mass, 12, pen.ink.accent);
  },
  drag(look, _sample, x, y) {
    const [x0, y0] = [look.at("x_pivot", 0), look.at("y_pivot", 0)];
    return { theta: Math.atan2(x - x0, y0 - y), theta_dot: 0 };
  },
};
export default scene;
