// A free body as Poinsot saw it: its ellipsoid of inertia rolls on a plane that rests, its cone of rotation on another cone.
// The angular momentum stands upright, whatever its direction in the run.

import type { Look } from "../../lab/result";
import type { Colour, NamedGraph, Piece, Place, Solid, Turn } from "./scene";
import { attitude, surface, turned } from "./table";

const place = (look: Look, k: number, names: readonly [string, string, string]): Place =>
  names.map((name) => look.at(name, k)) as Place;
const times = (factor: number, v: Place): Place => v.map((x) => factor * x) as Place;

/** Twice the energy is what the ellipsoid is scaled by: the end of omega lies on it. */
const scale = (look: Look) => 1 / Math.sqrt(2 * look.at("energy", 0) || 1);
/** The axis of rotation in the body: its end draws the polhode. */
const inBody = (look: Look, k: number) => times(scale(look), place(look, k, ["omega1", "omega2", "omega3"]));
/** And in space: the herpolhode. */
const inSpace = (look: Look, k: number) =>
  turned(upright(look), times(scale(look), place(look, k, ["omega_x", "omega_y", "omega_z"])));

/** Turns the angular momentum of the start to the vertical, by the shortest way. */
export function upright(look: Look): Turn {
  const l = place(look, 0, ["Lx", "Ly", "Lz"]);
  const length = Math.hypot(...l) || 1;
  const [x, y, z] = times(1 / length, l);
  // Half way between the two, from which the turn is twice that angle; a body that hangs head down goes over x.
  const w = 1 + z;
  const norm = Math.hypot(x, y, w);
  return norm < 1e-9 ? [1, 0, 0, 0] : [y / norm, -x / norm, 0, w / norm];
}

/** First b, then a. */
export function product(a: Turn, b: Turn): Turn {
  const [x, y, z, w] = a;
  const [p, q, r, s] = b;
  return [
    w * p + x * s + y * r - z * q,
    w * q - x * r + y * s + z * p,
    w * r + x * q - y * p + z * s,
    w * s - x * p - y * q - z * r,
  ];
}

const axes = (look: Look): Place =>
  ["i1", "i2", "i3"].map((name) => 1 / Math.sqrt(look.parameter(name))) as Place;
const pose = (look: Look, k: number) => ({
  place: [0, 0, 0] as Place,
  turn: product(upright(look), attitude(look, k)),
});

/** The principal axes as rods, the first with the least moment. */
const rods = (look: Look, share: number): Piece[] => {
  const all = axes(look);
  const radius = 0.018 * Math.max(...all) * share;
  return (["accent", "brass", "ink"] as const).map((colour, k) => {
    const to = all.map((a, axis) => (axis === k ? share * a : 0)) as Place;
    return { shape: "rod", from: times(-1, to), to, radius, colour };
  });
};

/** The plane lies below, where the other end of the axis of rotation touches it. */
export const ellipsoid: Solid = {
  kind: "solid",
  size: (look) => 1.15 * Math.max(...axes(look)),
  body: (look) => [
    { shape: "convex", colour: "glass", surface: surface({ point: [0, 0, 0], radius: 0, axes: axes(look) }) },
    ...rods(look, 1),
  ],
  pose,
  trace: (look, k) => {
    const [x, y, z] = times(-1, inSpace(look, k));
    return [x, y, z + 0.004 * axes(look)[0]];
  },
  paths: [{ on: "body", at: (look, k) => times(-1.002, inBody(look, k)), colour: "ink" }],
  table: (look) => -1 / (scale(look) * (look.at("L", 0) || 1)),
  frame: upright,
};

/** Some of the axes of rotation of a run, enough for a smooth cone. */
function fan(look: Look, at: (look: Look, k: number) => Place, colour: Colour): Piece {
  const last = look.times.length - 1;
  const parts = Math.min(last, 1500);
  const points = Array.from({ length: parts + 1 }, (_, k) => at(look, Math.round((k * last) / (parts || 1))));
  return { shape: "fan", points, colour };
}

/** The axis of rotation is where the two cones touch. */
export const cones: Solid = {
  kind: "solid",
  size: (look) => 0.8 * (Math.hypot(...inBody(look, 0)) || 1),
  body: (look) => [fan(look, inBody, "glass"), ...rods(look, 0.45)],
  still: (look) => [fan(look, inSpace, "brass")],
  pose,
  trace: inSpace,
  paths: [{ on: "body", at: inBody, colour: "ink" }],
  centre: (look) => [0, 0, 0.3 * Math.hypot(...inBody(look, 0))],
  frame: upright,
};

const polhode = (across: 1 | 2 | 3, up: 1 | 2 | 3): NamedGraph => ({
  title: { en: `Polhode, along axes ${across} and ${up}`, fr: `Polhodie, selon les axes ${across} et ${up}` },
  pair: [`omega${across}`, `omega${up}`],
});
/** The end of the axis of rotation, in the body. */
export const inBodyAxes: NamedGraph[] = [polhode(1, 2), polhode(1, 3), polhode(2, 3)];
/** And on the plane that the ellipsoid rolls on. */
export const polhodes: NamedGraph[] = [
  ...inBodyAxes,
  { title: { en: "Herpolhode", fr: "Herpolhodie" }, pair: ["herpolhode_x", "herpolhode_y"] },
];
