import type { Look } from "../lab/result";
import { cones, ellipsoid, polhodes } from "./kit/poinsot";
import type { Place, Solid } from "./kit/scene";

/** The edges of the box of unit mass that has these moments of inertia, up to a common factor. */
function edges(look: Look): Place {
  const [a, b, c] = ["i1", "i2", "i3"].map((name) => look.parameter(name)) as Place;
  const all: Place = [b + c - a, c + a - b, a + b - c].map((square) =>
    Math.sqrt(Math.max(square, 0)),
  ) as Place;
  const longest = Math.max(...all) || 1;
  return all.map((edge) => Math.max(edge / longest, 0.04)) as Place;
}

const scene: Solid = {
  kind: "solid",
  size: () => 1,
  body(look) {
    const size = edges(look);
    return [
      { shape: "box", size, colour: "ink" },
      {
        shape: "turned",
        profile: [
          [0, 0],
          [0.02, 0],
          [0.02, 0.8],
          [0, 0.8],
        ],
        colour: "accent",
      },
    ];
  },
  pose: (look, k) => ({
    place: [0, 0, 0],
    turn: [look.at("qx", k), look.at("qy", k), look.at("qz", k), look.at("qw", k)],
  }),
  trace: (look, k) => [0.8 * look.at("axis_x", k), 0.8 * look.at("axis_y", k), 0.8 * look.at("axis_z", k)],
  sphere: () => 0.8,
};
export default scene;

export const graphs = polhodes;

export const others = [
  { title: { en: "Ellipsoid on its plane", fr: "Ellipsoïde sur son plan" }, scene: ellipsoid },
  { title: { en: "Two cones", fr: "Deux cônes" }, scene: cones },
];
