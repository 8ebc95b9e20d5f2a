import type { Look } from "../lab/result";
import { frame } from "./kit/frame";
import type { Flat } from "./kit/scene";

const bodies = (look: Look) => look.list("masses").map((row) => row[0] ?? 0);

const view = (look: Look) => frame(look, [...bodies(look).keys()], 0);

const scene: Flat = {
  kind: "flat",
  reach: (look) => view(look).reach,
  centre: (look) => view(look).centre,
  draw(pen, look, sample) {
    const masses = bodies(look);
    const heaviest = Math.max(...masses);
    masses.forEach((mass, k) => {
      const colour = pen.ink.curves[k % pen.ink.curves.length] ?? pen.ink.ink;
      pen.trail(
        look,
        (n) => look.at(`x${k}`, n),
        (n) => look.at(`y${k}`, n),
        sample,
        colour,
      );
      pen.ball(
        look.at(`x${k}`, sample),
        look.at(`y${k}`, sample),
        4 + 12 * Math.cbrt(mass / heaviest),
        colour,
      );
    });
  },
  drag(look, sample, x, y) {
    const far = (k: number) => Math.hypot(x - look.at(`x${k}`, sample), y - look.at(`y${k}`, sample));
    const nearest = bodies(look).reduce((best, _, k) => (far(k) < far(best) ? k : best), 0);
    return { [`x${nearest}`]: x, [`y${nearest}`]: y };
  },
};
export default scene;
