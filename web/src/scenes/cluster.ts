import type { Look } from "../lab/result";
import { frame } from "./kit/frame";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const HEAVY = 2;

/** The ring in which every asteroid started. */
const rings = (look: Look) =>
  look.list("rings").flatMap(([count = 0], ring) => Array<number>(count).fill(ring));

/** Where the heavy bodies go, with room for the rings; the asteroids that are thrown out leave the picture. */
const view = (look: Look) =>
  frame(look, [0, 1], 1.3 * Math.max(...look.list("rings").map(([, , radius = 0]) => radius), 0));

const scene: Flat = {
  kind: "flat",
  reach: (look) => view(look).reach,
  centre: (look) => view(look).centre,
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
