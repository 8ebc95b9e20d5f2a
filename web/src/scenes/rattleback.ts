import { onTable, supportOf, surface } from "./kit/table";

/** Half an ellipsoid: what lies above its middle is cut off, and never touches. */
export default onTable((look) => {
  const support = supportOf(look);
  const whole = surface(support);
  return [
    {
      shape: "convex",
      colour: "ink",
      surface(normal) {
        const [x, y, z] = whole(normal);
        return [x, y, Math.min(z, support.point[2])];
      },
    },
  ];
}, 1.15);
