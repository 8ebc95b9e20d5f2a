import { onTable, supportOf, surface } from "./kit/table";
import { tippe } from "./kit/tippe";

/** A sphere is drawn as the tippe top that it is in T, a point as the tip of a cone, anything else as it is. */
export default onTable((look) => {
  const support = supportOf(look);
  const [across, , along] = support.axes;
  const z = support.point[2];
  if (across > 0 && across === along) return tippe(across, z);
  if (across > 0 || along > 0) return [{ shape: "convex", surface: surface(support), colour: "ink" }];
  const profile: [number, number][] = [
    [0, z],
    [-(4 / 9) * z, -z / 3],
    [0, -z / 3],
  ];
  return [
    { shape: "turned", profile, colour: "ink" },
    { shape: "stripe", profile: profile.slice(0, -1) },
  ];
});
