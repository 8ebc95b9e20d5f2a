import { turnOf, type Solid } from "./kit/scene";

/** A sphere, cut above, with a stem; body axis 3 points from the centre of mass to the centre of the sphere. */
function profile(radius: number): [number, number][] {
  const LAST = 0.72 * Math.PI;
  const arc = Array.from({ length: 25 }, (_, k): [number, number] => {
    const angle = (k / 24) * LAST;
    return [radius * Math.sin(angle), -radius * Math.cos(angle)];
  });
  return [...arc, [0, -radius * Math.cos(LAST)]];
}

const scene: Solid = {
  kind: "solid",
  size: (look) => look.parameter("radius") * 2.4,
  body(look) {
    const r = look.parameter("radius");
    return [
      { shape: "turned", profile: profile(r), colour: "ink" },
      { shape: "stripe", profile: profile(r).slice(0, -1) },
      {
        shape: "turned",
        profile: [
          [0, 0.6 * r],
          [0.16 * r, 0.6 * r],
          [0.2 * r, 1.5 * r],
          [0, 1.55 * r],
        ],
        colour: "brass",
      },
    ];
  },
  pose: (look, k) => ({
    place: [look.at("cx", k), look.at("cy", k), look.parameter("radius")],
    turn: turnOf(look.at("psi", k), look.at("theta", k), look.at("phi", k)),
  }),
  trace: (look, k) => [look.at("contact_x", k), look.at("contact_y", k), look.parameter("radius") * 0.02],
  table: () => 0,
  follow: true,
};
export default scene;
