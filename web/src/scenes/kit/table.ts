// A convex body on a table: its support function h(n) = point.n + radius |n| + |axes n| gives the surface that is drawn.

import type { Look } from "../../lab/result";
import { ballProfile, type Piece, type Place, type Solid, type Turn } from "./scene";

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

const turn = (look: Look, k: number): Turn => [
  look.at("qx", k),
  look.at("qy", k),
  look.at("qz", k),
  look.at("qw", k),
];
/** How far the body reaches from its centre of mass. */
function reach(look: Look): number {
  const support = supportOf(look);
  const most = Math.max(...support.axes) + support.radius + Math.hypot(...support.point);
  return most || 1;
}

export const onTable: Solid = {
  kind: "solid",
  size: (look) => 1.7 * reach(look),
  body(look): Piece[] {
    const support = supportOf(look);
    const r = reach(look);
    if (Number.isFinite(look.parameter("tip"))) {
      // Of a top on a tip only the tip is given: a cone about its centre of mass.
      const [d, tip] = [look.parameter("d"), support.radius];
      const cone: [number, number][] = [...ballProfile(tip, -d).slice(0, 9), [0.5 * d, d / 3], [0, d / 3]];
      return [
        { shape: "turned", profile: cone, colour: "ink" },
        { shape: "stripe", profile: cone.slice(0, -1) },
      ];
    }
    const body: Piece = { shape: "convex", surface: surface(support), colour: "ink" };
    // What is out of balance shows its axis.
    if (support.point[2] === 0 || Math.max(...support.axes) > 0) return [body];
    return [
      body,
      { shape: "rod", from: support.point, to: [0, 0, 1.45 * r], radius: 0.13 * r, colour: "brass" },
    ];
  },
  pose: (look, k) => ({ place: [look.at("x", k), look.at("y", k), look.at("z", k)], turn: turn(look, k) }),
  trace(look, k) {
    const touch: Place = [look.at("contact1", k), look.at("contact2", k), look.at("contact3", k)];
    const [dx, dy] = turned(turn(look, k), touch);
    return [look.at("x", k) + dx, look.at("y", k) + dy, 0.01 * reach(look)];
  },
  table: () => 0,
  follow: true,
};
