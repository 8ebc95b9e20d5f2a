import type { Look } from "../lab/result";
import { polynomial } from "./kit/landscape";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

/** The wire: a polynomial and waves, as the parameters say; `y` at every sample is the core's own. */
export function wire(look: Look): (x: number) => number {
  const profile = polynomial(look.list("profile").map(([c = 0]) => c));
  const waves = look.list("waves");
  return (x) => waves.reduce((y, [a = 0, k = 0]) => y + a * Math.cos(k * x), profile(x));
}
const reach = (look: Look) => Math.max(look.reach("x"), 0.6 * look.reach("y")) * 1.2 || 1;

const scene: Flat = {
  kind: "flat",
  reach,
  centre(look) {
    const y = look.column("y");
    return [0, (Math.min(...y) + Math.max(...y)) / 2];
  },
  draw(pen, look, sample) {
    const height = wire(look);
    const half = Math.min(pen.half, 4 * reach(look));
    const curve = Array.from({ length: 241 }, (_, k): Point => {
      const x = half * (k / 120 - 1);
      return [x, Math.min(Math.max(height(x), -1e3), 1e3)];
    });
    pen.line(curve, 2.4);
    pen.ball(look.at("x", sample), look.at("y", sample), 12, pen.ink.accent);
  },
};
export default scene;
