// The scene of a system that has none of its own, by the names of its columns.

import type { Look } from "../../lab/result";
import { recorder } from "./recorder";
import { attitude, onTable } from "./table";
import { ballProfile, type Flat, type Place, type Scene, type Solid } from "./scene";

export function usual(look: Look): Scene {
  if (look.has("qw") && look.has("contact3")) return onTable();
  if (look.has("qw") || (look.has("psi") && look.has("theta") && look.has("phi"))) return turning;
  if (look.has("x") && look.has("y") && look.has("z")) return path;
  if (look.has("x") && look.has("y")) return plane;
  return recorder(look.state[0] ?? "t");
}

/** The axis of a body, as its quaternion turns it. */
export function axis(look: Look, k: number): Place {
  const [x, y, z, w] = attitude(look, k);
  return [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
}

const turning: Solid = {
  kind: "solid",
  size: () => 1,
  body: () => [
    { shape: "box", size: [0.7, 0.4, 1], colour: "ink" },
    { shape: "rod", from: [0, 0, 0], to: [0, 0, 0.8], radius: 0.02, colour: "accent" },
  ],
  pose: (look, k) => ({ place: [0, 0, 0], turn: attitude(look, k) }),
  trace: (look, k) => axis(look, k).map((x) => 0.8 * x) as Place,
  sphere: () => 0.8,
};

const plane: Flat = {
  kind: "flat",
  reach: (look) => look.reach("x", "y"),
  draw(pen, look, sample) {
    pen.cross(pen.half, 0.8, [2, 4]);
    pen.path(look, "x", "y", sample);
    pen.ball(look.at("x", sample), look.at("y", sample), 10);
  },
};

/** A point that draws its path in space; the middle of what it reaches is the middle of the picture. */
const middle = (look: Look): Place =>
  ["x", "y", "z"].map((name) => {
    const column = look.column(name);
    return (Math.min(...column) + Math.max(...column)) / 2;
  }) as Place;
const place = (look: Look, k: number): Place => [look.at("x", k), look.at("y", k), look.at("z", k)];
export const path: Solid = {
  kind: "solid",
  size: (look) => Math.max(...["x", "y", "z"].map((name) => look.reach(name))) * 0.62 || 1,
  body: (look) => [{ shape: "turned", profile: ballProfile(0.022 * path.size(look)), colour: "ink" }],
  pose: (look, k) => ({ place: place(look, k), turn: [0, 0, 0, 1] }),
  trace: place,
  centre: middle,
};
