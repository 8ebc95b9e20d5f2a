import { ballProfile, turnOf, type Solid } from "./kit/scene";

/** Body axis 3 points from the pivot to the mass. */
const scene: Solid = {
  kind: "solid",
  size: (look) => 1.3 * look.parameter("l"),
  body(look) {
    const l = look.parameter("l");
    return [
      { shape: "rod", from: [0, 0, 0], to: [0, 0, l], radius: 0.012 * l, colour: "brass" },
      { shape: "turned", profile: ballProfile(0.09 * l, l), colour: "ink" },
      { shape: "turned", profile: ballProfile(0.03 * l), colour: "brass" },
    ];
  },
  pose: (look, k) => ({
    place: [0, 0, 0],
    turn: turnOf(look.at("phi", k) + Math.PI / 2, Math.PI - look.at("theta", k), 0),
  }),
  trace: (look, k) => [look.at("x", k), look.at("y", k), look.at("z", k)],
  sphere: (look) => look.parameter("l"),
  table: (look) => -1.12 * look.parameter("l"),
  centre: (look) => [0, 0, -0.5 * look.parameter("l")],
};
export default scene;
