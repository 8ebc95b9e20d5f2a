import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const HEAVY = 2;

/** The ring in which every asteroid started. */
const rings = (look: Look) =>
  look.list("rings").flatMap(([count = 0], ring) => Array<number>(count).fill(ring));

/** Where the heavy bodies go, with room for the rings; the asteroids that are thrown out leave the picture. */
function frame(look: Look): { centre: Point; reach: Point } {
  const room = 1.3 * Math.max(...look.list("rings").map(([, , radius = 0]) => radius), 0);
  const side = (axis: string): [number, number] => {
    const all = [look.column(`${axis}0`), look.column(`${axis}1`)];
    const [low, high] = [
      Math.min(...all.map((one) => Math.min(...one))),
      Math.max(...all.map((one) => Math.max(...one))),
    ];
    return [(low + high) / 2, (high - low) / 2 + room || 1];
  };
  const [[x, across], [y, up]] = [side("x"), side("y")];
  return { centre: [x, y], reach: [across, up] };
}

const scene: Flat = {
  kind: "flat",
  reach: (look) => frame(look).reach,
  centre: (look) => frame(look).centre,
  draw(pen, look, sample) {
    const at = (body: number): Point => [look.at(`x${body}`, sample), look.at(`y${body}`, sample)];
    for (let body = 0; body < HEAVY; body++)
      pen.path(look, `x${body}`, `y${body}`, sample, pen.ink.curves[body]);
    rings(look).forEach((ring, k) => {
      pen.dot(...at(HEAVY + k), 2.4, pen.ink.curves[ring % pen.ink.curves.length]);
    });
    const heavy = look.list("masses").map(([m = 0]) => m);
    for (let body = 0; body < HEAVY; body++)
      pen.ball(...at(body), 11 * Math.cbrt((heavy[body] ?? 1) / Math.max(...heavy)), pen.ink.ink);
  },
};
export default scene;
