// A convex body on a table: its support function h(n) = point.n + radius |n| + |axes n| gives the surface that is drawn.

import { bodyIn, outline } from "../../lab/body";
import type { Look } from "../../lab/result";
import { turnOf, type Piece, type Place, type Solid, type Turn } from "./scene";

export interface Support {
  point: Place;
  radius: number;
  axes: Place;
}

/** The support by a system's parameters, in whichever of their forms it gives them. */
export function supportOf(look: Look): Support {
  const p = (name: string) => look.parameter(name) || 0;
  const has = (...names: string[]) => names.every((name) => Number.isFinite(look.parameter(name)));
  if (has("point3", "axis3"))
    return {
      point: [p("point1"), p("point2"), p("point3")],
      radius: p("radius"),
      axes: [p("axis1"), p("axis2"), p("axis3")],
    };
  if (has("across", "along"))
    return { point: [0, 0, p("point")], radius: 0, axes: [p("across"), p("across"), p("along")] };
  if (has("a", "b", "c")) return { point: [0, 0, p("h")], radius: 0, axes: [p("a"), p("b"), p("c")] };
  if (has("a", "b")) return { point: [0, 0, p("h")], radius: 0, axes: [p("b"), p("b"), p("a")] };
  if (has("tip")) return { point: [0, 0, -p("d")], radius: p("tip"), axes: [0, 0, 0] };
  if (has("edge")) {
    const flat = p("radius") - p("edge");
    return { point: [0, 0, 0], radius: p("edge"), axes: [flat, flat, 0] };
  }
  return { point: [0, 0, p("alpha") * p("radius")], radius: p("radius"), axes: [0, 0, 0] };
}

/** The point of the surface with an outward normal: the gradient of the support function. */
export function surface({ point, radius, axes }: Support): (normal: Place) => Place {
  return (n) => {
    const length = Math.hypot(...n) || 1;
    const reach = Math.hypot(...n.map((x, k) => x * (axes[k] ?? 0))) || 1;
    return n.map(
      (x, k) => (point[k] ?? 0) + (radius * x) / length + ((axes[k] ?? 0) ** 2 * x) / reach,
    ) as Place;
  };
}

export function turned([x, y, z, w]: Turn, v: Place): Place {
  const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])] as const;
  return [
    v[0] + w * t[0] + y * t[2] - z * t[1],
    v[1] + w * t[1] + z * t[0] - x * t[2],
    v[2] + w * t[2] + x * t[1] - y * t[0],
  ];
}

/** How a body is turned: by a quaternion, or by T's angles. */
export function attitude(look: Look, k: number): Turn {
  return look.has("qw")
    ? [look.at("qx", k), look.at("qy", k), look.at("qz", k), look.at("qw", k)]
    : turnOf(look.at("psi", k), look.at("theta", k), look.at("phi", k));
}

/** How far the body reaches from its centre of mass. */
export function reach(look: Look): number {
  const support = supportOf(look);
  const most = Math.max(...support.axes) + support.radius + Math.hypot(...support.point);
  return most || 1;
}

/** Where the body touches the table, in body axes. */
export function touch(look: Look, k: number): Place {
  if (look.has("contact3")) return [look.at("contact1", k), look.at("contact2", k), look.at("contact3", k)];
  const [x, y, z, w] = attitude(look, k);
  return surface(supportOf(look))(turned([-x, -y, -z, w], [0, 0, -1]));
}

/** The body as it was drawn, or as its support function has it. */
const plain = (look: Look): Piece[] => {
  const drawn = bodyIn(look.result.scenario);
  if (!drawn) return [{ shape: "convex", surface: surface(supportOf(look)), colour: "ink" }];
  // It stands on its lower end; body axes begin at the centre of mass.
  const profile = outline(drawn, supportOf(look).point[2]);
  return [
    { shape: "turned", profile, colour: "ink" },
    { shape: "stripe", profile },
  ];
};

/** The scene of a body that goes about on a table, with its contact point drawn on both. */
export function onTable(body: (look: Look) => Piece[] = plain, room = 1.7): Solid {
  return {
    kind: "solid",
    size: (look) => room * reach(look),
    body,
    pose: (look, k) => ({
      place: (look.has("gx") ? ["gx", "gy", "gz"] : ["x", "y", "z"]).map((name) => look.at(name, k)) as Place,
      turn: attitude(look, k),
    }),
    trace: (look, k) => [look.at("contact_x", k), look.at("contact_y", k), 0.01 * reach(look)],
    // A little outside, so that it is seen.
    paths: [{ on: "body", at: (look, k) => touch(look, k).map((x) => 1.008 * x) as Place }],
    table: () => 0,
    follow: true,
  };
}
