import { turnOf, type Place, type Solid } from "./kit/scene";
import { supportOf, touch } from "./kit/table";
import { tippe } from "./kit/tippe";

/** Body axis 3 points from the centre of mass to the centre of the sphere, which is the middle of the picture. */
const scene: Solid = {
  kind: "solid",
  size: (look) => look.parameter("radius") * 2.4,
  body: (look) => tippe(look.parameter("radius")),
  pose: (look, k) => ({
    place: [look.at("cx", k), look.at("cy", k), look.parameter("radius")],
    turn: turnOf(look.at("psi", k), look.at("theta", k), look.at("phi", k)),
  }),
  trace: (look, k) => [look.at("contact_x", k), look.at("contact_y", k), look.parameter("radius") * 0.02],
  paths: [
    {
      on: "body",
      at(look, k) {
        const { point } = supportOf(look);
        return touch(look, k).map((x, axis) => 1.008 * (x - (point[axis] ?? 0))) as Place;
      },
    },
  ],
  table: () => 0,
  follow: true,
};
export default scene;
