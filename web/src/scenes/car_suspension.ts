import type { Look } from "../lab/result";
import type { Point } from "./kit/pen";
import type { Flat } from "./kit/scene";

const size = (look: Look) => look.parameter("wavelength");

/** The road at a distance ahead of the car; under the car it is the column `road`. */
export function road(look: Look, sample: number): (ahead: number) => number {
  const [amplitude, wavelength] = [look.parameter("amplitude"), look.parameter("wavelength")];
  const gone = look.parameter("speed") * look.at("t", sample);
  return (ahead) => amplitude * Math.sin((2 * Math.PI * (gone + ahead)) / wavelength);
}

const scene: Flat = {
  kind: "flat",
  reach: (look) => [size(look), Math.max(0.62 * size(look), look.reach("x") * 1.2)],
  centre: (look) => [0, 0.35 * size(look)],
  draw(pen, look, sample) {
    const s = size(look);
    const height = road(look, sample);
    const half = pen.half;
    const ground = Array.from({ length: 161 }, (_, k): Point => {
      const ahead = half * (k / 80 - 1);
      return [ahead, height(ahead)];
    });
    pen.area([...ground, [half, -9 * s], [-half, -9 * s]], pen.ink.faint, 0.16);
    pen.line(ground, 2);
    // The wheels stand a wavelength apart, so both meet the same height.
    const [wheel, floor] = [0.13 * s, 0.45 * s + look.at("x", sample)];
    for (const x of [-s / 2, s / 2]) {
      const y = height(x) + wheel;
      pen.spring([x, y], [x, floor], 0.04 * s, 5);
      pen.circle(x, y, wheel, pen.ink.ink, 4);
      pen.ball(x, y, 3);
    }
    const body: Point[] = (
      [
        [-0.78, 0],
        [0.8, 0],
        [0.8, 0.16],
        [0.42, 0.2],
        [0.22, 0.4],
        [-0.42, 0.4],
        [-0.66, 0.2],
        [-0.78, 0.18],
      ] as const
    ).map(([x, y]) => [x * s, floor + y * s]);
    pen.area(body, pen.ink.curves[0]);
    pen.line([...body, body[0] ?? [0, 0]], 1.5);
    const glass: Point[] = (
      [
        [-0.36, 0.21],
        [-0.02, 0.21],
        [-0.02, 0.35],
        [-0.36, 0.35],
      ] as const
    ).map(([x, y]) => [x * s, floor + y * s]);
    pen.area(glass, pen.ink.paper);
  },
};
export default scene;
