import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const lengths = (look: Look) => look.list("lengths").map(([l = 0]) => l);
const masses = (look: Look) => look.list("masses").map(([m = 0]) => m);

const length = (look: Look) => lengths(look).reduce((sum, l) => sum + l, 0);

/** The pivot and every mass. */
export function chain(look: Look, sample: number): Point[] {
  let [x, y] = [0, 0];
  const joints = lengths(look).map((l, k): Point => {
    const theta = look.at(`theta${k + 1}`, sample);
    x += l * Math.sin(theta);
    y -= l * Math.cos(theta);
    return [x, y];
  });
  return [[0, 0], ...joints];
}

const scene: Flat = {
  kind: "flat",
  reach: length,
  draw(pen, look, sample) {
    const [whole, all] = [length(look), masses(look)];
    const joints = chain(look, sample);
    const heaviest = Math.max(...all);
    const size = 13 / Math.sqrt(Math.max(all.length / 3, 1));
    pen.ceiling(0.16 * whole, 0);
    pen.path(look, "x", "y", sample);
    pen.line(joints, 2.5);
    joints.slice(1).forEach((joint, k) => {
      const last = k === all.length - 1;
      pen.ball(...joint, size * Math.cbrt((all[k] ?? 1) / heaviest), last ? pen.ink.accent : pen.ink.ink);
    });
  },
  drag(look, sample, x, y) {
    const joints = chain(look, sample);
    const far = (k: number) => Math.hypot(x - (joints[k]?.[0] ?? 0), y - (joints[k]?.[1] ?? 0));
    let nearest = 1;
    for (let k = 2; k < joints.length; k++) if (far(k) < far(nearest)) nearest = k;
    const [x0, y0] = joints[nearest - 1] ?? [0, 0];
    return { [`theta${nearest}`]: Math.atan2(x - x0, y0 - y), [`theta${nearest}_dot`]: 0 };
  },
};
export default scene;
