import { bodyIn, outline } from "../lab/body";
import type { Look } from "../lab/result";
import { inBodyAxes } from "./kit/poinsot";
import type { Piece, Place, Solid } from "./kit/scene";
import { attitude } from "./kit/table";

const centre = (look: Look): Place => {
  const [x = 0, y = 0, z = 0] = look.list("centre").map(([c = 0]) => c);
  return [x, y, z];
};

/** The edges of the box with the body's mass and moments of inertia, about its own centre. */
function edges(look: Look): Place {
  const [m, c] = [look.parameter("m"), centre(look)];
  const fixed = look.whole.parameters["about"] !== "centre_of_mass";
  const far = c.reduce((sum, x) => sum + x * x, 0);
  const own = ["i1", "i2", "i3"].map(
    (name, k) => look.parameter(name) - (fixed ? m * (far - (c[k] ?? 0) ** 2) : 0),
  );
  const sum = own.reduce((a, b) => a + b, 0);
  const least = 0.03 * reach(look);
  return own.map((i) => Math.max(Math.sqrt(Math.max((6 * (sum - 2 * i)) / m, 0)), least)) as Place;
}
/** To the centre of mass, or half way up what was drawn. */
const reach = (look: Look) => {
  const drawn = bodyIn(look.result.scenario);
  return (drawn ? 0.6 * drawn.height : Math.hypot(...centre(look))) || 1;
};

const stands = (look: Look) => Math.min(...look.column("gz")) > 0.35 * reach(look);

const scene: Solid = {
  kind: "solid",
  size: (look) => 1.45 * reach(look),
  body(look) {
    const r = reach(look);
    const drawn = bodyIn(look.result.scenario);
    const axis: Piece = {
      shape: "rod",
      from: [0, 0, 0],
      to: [0, 0, 1.6 * r],
      radius: 0.014 * r,
      colour: "accent",
    };
    if (drawn) {
      const profile = outline(drawn);
      return [{ shape: "turned", profile, colour: "ink" }, { shape: "stripe", profile }, axis];
    }
    return [
      { shape: "rod", from: [0, 0, 0], to: centre(look), radius: 0.03 * r, colour: "brass" },
      { shape: "box", size: edges(look), at: centre(look), colour: "ink" },
      axis,
    ];
  },
  pose: (look, k) => ({ place: [0, 0, 0], turn: attitude(look, k) }),
  trace(look, k) {
    const r = 1.6 * reach(look);
    return [r * look.at("axis_x", k), r * look.at("axis_y", k), r * look.at("axis_z", k)];
  },
  sphere: (look) => 1.6 * reach(look),
  table: (look) => (stands(look) ? 0 : undefined),
  centre: (look) => [0, 0, stands(look) ? 0.6 * reach(look) : 0],
};
export default scene;

export const graphs = inBodyAxes;
