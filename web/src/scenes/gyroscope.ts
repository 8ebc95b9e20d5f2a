import type { Look } from "../lab/result";
import { turnOf, type Solid } from "./kit/scene";

/** The cone that stands on its tip and whose centre of mass is at d: it is 4/3 d high. */
const height = (look: Look) => (4 / 3) * Math.abs(look.parameter("d")) || 1;

const stands = (look: Look) => Math.min(...look.column("axis_z")) > 0.3;

const scene: Solid = {
  kind: "solid",
  size: (look) => (stands(look) ? 1 : 1.2) * height(look),
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
  // A top that sinks towards its support turns in gimbals, above no table.
  table: (look) => (stands(look) ? 0 : undefined),
  centre: (look) => [0, 0, stands(look) ? height(look) * 0.5 : 0],
};
export default scene;
