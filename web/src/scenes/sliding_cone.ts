import { ballProfile } from "./kit/scene";
import { onTable } from "./kit/table";

/** A cone about its centre of mass, a quarter of its height below the base, with a round tip. */
export default onTable((look) => {
  const [d, tip] = [look.parameter("d"), look.parameter("tip")];
  const top = (d + tip) / 3;
  const base = (4 / 9) * (d + tip);
  const profile: [number, number][] = [...ballProfile(tip, -d).slice(0, 9), [base, top], [0, top]];
  const stem: [number, number][] = [
    [0, top],
    [0.03 * d, top],
    [0.03 * d, top + 0.3 * d],
    [0, top + 0.3 * d],
  ];
  return [
    { shape: "turned", profile, colour: "ink" },
    { shape: "stripe", profile: profile.slice(0, -1) },
    { shape: "turned", profile: stem, colour: "brass" },
  ];
}, 1.25);
