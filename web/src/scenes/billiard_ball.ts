import { onTable, reach, supportOf, surface } from "./kit/table";

/** With a spot at each pole besides the stripes: its spin is seen about any axis. */
export default onTable((look) => {
  const r = reach(look);
  const spot = [0.2, 0.1, 0].map((angle): [number, number] => [
    1.006 * r * Math.sin(angle),
    1.006 * r * Math.cos(angle),
  ]);
  const under = spot.map(([x, z]): [number, number] => [x, -z]);
  return [
    { shape: "convex", surface: surface(supportOf(look)), colour: "ink" },
    { shape: "turned", profile: spot, colour: "accent" },
    { shape: "turned", profile: under, colour: "accent" },
  ];
});
