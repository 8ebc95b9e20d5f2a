import type { Look } from "../lab/result";
import { turnOf, type Solid } from "./kit/scene";

/** The cone that stands on its tip and whose centre of mass is at d: it is 4/3 d high. */
const height = (look: Look) => (4 / 3) * Math.abs(look.parameter("d")) || 1;

const scene: Solid = {
  kind: "solid",
  size: height,
  body(look) {
    const h = height(look);
    const profile: [number, number][] = [
      [0, 0],
      [h / 3, h],
      [0, h],
    ];
    return [
      { shape: "turned", profile, colour: "ink" },
      { shape: "stripe", profile: profile.slice(0, -1) },
      {
        shape: "turned",
        profile: [
          [0, h],
          [h * 0.025, h],
          [h * 0.025, h * 1.2],
          [0, h * 1.2],
        ],
        colour: "brass",
      },
    ];
  },
  pose: (look, k) => ({
    place: [0, 0, 0],
    turn: turnOf(look.at("psi", k), look.at("theta", k), look.at("phi", k)),
  }),
  trace(look, k) {
    const r = height(look) * 1.2;
    return [r * look.at("axis_x", k), r * look.at("axis_y", k), r * look.at("axis_z", k)];
  },
  sphere: (look) => height(look) * 1.2,
  // A top that sinks below its support turns in gimbals: there the table lies out of its way.
  table: (look) => (Math.min(...look.column("axis_z")) > 0.3 ? 0 : -height(look) * 1.3),
  centre: (look) => [0, 0, Math.min(...look.column("axis_z")) > 0.3 ? height(look) * 0.5 : 0],
};
export default scene;
