// The vectors of a body's motion, put together from what the core computed: geometry, no mechanics.

import type { Look } from "../../lab/result";
import type { Place, Solid } from "./scene";
import { turned } from "./table";

export const VECTORS = ["omega", "momentum", "axis", "weight", "normal", "slip"] as const;
export type VectorName = (typeof VECTORS)[number];

export interface Vector {
  name: VectorName;
  from: (sample: number) => Place;
  by: (sample: number) => Place;
}

const sum = (...terms: [number, Place][]): Place =>
  [0, 1, 2].map((k) => terms.reduce((all, [factor, place]) => all + factor * (place[k] ?? 0), 0)) as Place;

/** The vectors that a run has, in the order of `VECTORS`; none where nothing says how the body is turned. */
export function vectorsOf(solid: Solid, look: Look): Vector[] {
  const has = (...names: string[]) => names.every((name) => look.has(name));
  const columns =
    (...names: [string, string, string]) =>
    (k: number) =>
      names.map((name) => look.at(name, k)) as Place;
  const pose = (k: number) => solid.pose(look, k);
  const place = (k: number) => pose(k).place;
  const axis = (k: number) => turned(pose(k).turn, [0, 0, 1]);
  /** T's frame: u along the node, b upwards from it, the axis. */
  const node = (k: number): Place => [Math.cos(look.at("psi", k)), Math.sin(look.at("psi", k)), 0];
  const framed = ([u, b, a]: Place, k: number) => {
    const [[x, y], [p, q, r]] = [node(k), axis(k)];
    // The axis times the node.
    return sum([u, node(k)], [b, [-r * y, r * x, p * y - q * x]], [a, [p, q, r]]);
  };
  const list: Vector[] = [];
  if (!has("qw") && !has("psi", "theta")) return list;
  const add = (name: VectorName, from: Vector["from"], by: Vector["by"]) => list.push({ name, from, by });

  const omegas = columns("omega1", "omega2", "omega3");
  if (has("qw", "omega1")) add("omega", place, (k) => turned(pose(k).turn, omegas(k)));
  else if (has("omega1", "omega2", "omega3", "psi")) add("omega", place, (k) => framed(omegas(k), k));
  else if (has("psi_dot", "theta_dot", "phi_dot"))
    add("omega", place, (k) => {
      const [psi, theta, phi] = columns("psi_dot", "theta_dot", "phi_dot")(k);
      return sum([psi, [0, 0, 1]], [theta, node(k)], [phi, axis(k)]);
    });

  // Where the picture turns space, what is given in space turns with it.
  const frame = solid.frame?.(look) ?? ([0, 0, 0, 1] as const);
  const momenta = columns("Lx", "Ly", "Lz");
  if (has("Lx", "Ly", "Lz")) add("momentum", place, (k) => turned([...frame], momenta(k)));
  else if (has("L_x", "L_y", "L_z")) add("momentum", place, columns("L_x", "L_y", "L_z"));
  else if (has("L_A", "L_A3", "L_Az", "omega1") && !has("qw"))
    // Of a symmetric top: along the axis, along the vertical, and the rest along the node, with theta.
    add("momentum", place, (k) => {
      const [along, up, whole] = columns("L_A3", "L_Az", "L_A")(k);
      const [s, c] = [Math.sin(look.at("theta", k)), Math.cos(look.at("theta", k))];
      const b = Math.abs(s) > 1e-9 ? (up - along * c) / s : 0;
      const u = Math.sqrt(Math.max(whole ** 2 - along ** 2 - b ** 2, 0)) * Math.sign(look.at("omega1", k));
      return framed([u, b, along], k);
    });

  add("axis", place, axis);

  if (look.parameter("g") > 0 && has("potential")) {
    const arm = look.parameter("d");
    const hangs = Number.isFinite(arm) && !has("gx") && !has("contact3");
    const centre = hangs ? (k: number) => sum([1, place(k)], [arm, axis(k)]) : place;
    add("weight", has("gx", "gy", "gz") ? columns("gx", "gy", "gz") : centre, () => [0, 0, -1]);
  }
  const touch = (k: number): Place => [look.at("contact_x", k), look.at("contact_y", k), 0];
  if (has("contact_x", "contact_y", "normal")) add("normal", touch, (k) => [0, 0, look.at("normal", k)]);
  if (has("contact_x", "contact_y", "slip_x", "slip_y"))
    add("slip", touch, (k) => [look.at("slip_x", k), look.at("slip_y", k), 0]);
  return list;
}

/** The largest of a vector over a run, of which some samples do. */
export function largest({ by }: Vector, look: Look): number {
  const last = look.times.length - 1;
  const sizes = Array.from({ length: 257 }, (_, k) => Math.hypot(...by(Math.round((k / 256) * last))));
  return Math.max(...sizes.filter((size) => Number.isFinite(size)), 0);
}
