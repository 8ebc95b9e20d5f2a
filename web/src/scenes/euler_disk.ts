import { onTable } from "./kit/table";

/** A disc of metal with a round edge. */
export default onTable((look) => {
  const [radius, edge] = [look.parameter("radius"), look.parameter("edge")];
  const arc = Array.from({ length: 13 }, (_, k): [number, number] => {
    const angle = (k / 12 - 0.5) * Math.PI;
    return [radius - edge + edge * Math.cos(angle), edge * Math.sin(angle)];
  });
  // A sharp one still has two sides.
  const thick = Math.max(edge, radius / 100);
  const profile: [number, number][] = [[0, -thick], ...arc, [0, thick]];
  return [
    { shape: "turned", profile, colour: "brass" },
    { shape: "stripe", profile },
  ];
}, 1.5);
