// A tippe top, about the middle of its sphere.

import type { Piece } from "./scene";

/** Where the sphere is cut, as an angle from below. */
const CUT = 0.68 * Math.PI;

/**
 * A sphere that is cut above and has a stem, which ends where the sphere would: it touches as the complete sphere does, and
 * what is missing of that is of glass. `z` is the height of the middle.
 */
export function tippe(radius: number, z = 0): Piece[] {
  const arc = (from: number, to: number) =>
    Array.from({ length: 25 }, (_, k): [number, number] => {
      const angle = from + (k / 24) * (to - from);
      return [radius * Math.sin(angle), z - radius * Math.cos(angle)];
    });
  const ball = arc(0, CUT);
  const top = z - radius * Math.cos(CUT);
  return [
    { shape: "turned", profile: [...ball, [0, top]], colour: "ink" },
    { shape: "stripe", profile: ball },
    {
      shape: "turned",
      profile: [[0, top], [0.13 * radius, top], ...arc(0.95 * Math.PI, Math.PI)],
      colour: "brass",
    },
    { shape: "turned", profile: arc(CUT, 0.95 * Math.PI), colour: "glass" },
  ];
}
