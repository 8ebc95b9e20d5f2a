import type { Look } from "../lab/result";
import { turnOf, type Place, type Solid } from "./kit/scene";

/** The spheroid with these moments of inertia: half its width and half its height, the larger one being one. */
function halves(look: Look): [number, number] {
  const [i1, i3] = [look.parameter("i1"), look.parameter("i3")];
  const [width, height] = [Math.sqrt(2.5 * i3), Math.sqrt(Math.max(5 * i1 - 2.5 * i3, 0))];
  const larger = Math.max(width, height) || 1;
  return [width / larger, Math.max(height / larger, 0.05)];
}

const scene: Solid = {
  kind: "solid",
  size: () => 1.4,
  body(look) {
    const [width, height] = halves(look);
    const profile = Array.from({ length: 25 }, (_, k): [number, number] => {
      const angle = (k / 24) * Math.PI;
      return [0.75 * width * Math.sin(angle), -0.75 * height * Math.cos(angle)];
    });
    return [
      { shape: "turned", profile, colour: "ink" },
      { shape: "stripe", profile },
      { shape: "rod", from: [0, 0, 0], to: [0, 0, 1.05], radius: 0.02, colour: "brass" },
    ];
  },
  pose: (look, k) => ({
    place: [0, 0, 0],
    turn: turnOf(look.at("psi", k), look.at("theta", k), look.at("phi", k)),
  }),
  trace: (look, k) => ["axis_x", "axis_y", "axis_z"].map((name) => 1.05 * look.at(name, k)) as Place,
  sphere: () => 1.05,
};
export default scene;
