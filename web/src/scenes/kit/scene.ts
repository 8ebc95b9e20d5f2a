// What a scene is: a small file beside this folder, named after its system, that maps a run's columns to shapes.

import type { Text } from "../../core";
import type { Ink } from "../../draw/ink";
import type { Look } from "../../lab/result";
import type { Pen, Point } from "./pen";

/** A flat scene, in the system's own lengths. */
export interface Flat {
  kind: "flat";
  /** How far must be seen about the middle, to each side: the same across and upwards where it is one number. */
  reach: (look: Look) => number | Point;
  /** The middle, where it is not the origin. */
  centre?: (look: Look) => Point;
  draw: (pen: Pen, look: Look, sample: number) => void;
  /** The coordinates across and upwards, where what has a place in the parameters (magnets) is drawn and can be moved. */
  places?: [string, string];
  /** What the start becomes where a person drags to a place. */
  drag?: (look: Look, sample: number, x: number, y: number) => Record<string, number>;
}

/** A place in space, z upwards. */
export type Place = [number, number, number];
/** A turn as a quaternion (x, y, z, w). */
export type Turn = [number, number, number, number];

/** A solid scene. */
export interface Solid {
  kind: "solid";
  /** The size of everything; the camera stands at several times it. */
  size: (look: Look) => number;
  body: (look: Look) => Piece[];
  pose: (look: Look, sample: number) => { place: Place; turn: Turn };
  /** A path that is drawn as far as it has been run through. */
  trace: (look: Look, sample: number) => Place;
  /** Further paths, in space or on the body and going with it. */
  paths?: Path[];
  /** Radius of a thin sphere about the origin on which the trace lies; none where zero. */
  sphere?: (look: Look) => number;
  /** Height of the table; none where absent. */
  table?: (look: Look) => number | undefined;
  /** What rests while the body moves. */
  still?: (look: Look) => Piece[];
  /** How space is turned in the picture, where it is. */
  frame?: (look: Look) => Turn;
  /** The camera goes with the body, and the table with the camera. */
  follow?: boolean;
  /** Where the camera looks. */
  centre?: (look: Look) => Place;
  /** From where it looks first: round about the vertical, up from the horizon. */
  from?: { round: number; up: number };
}

export interface Path {
  on: "space" | "body";
  at: (look: Look, sample: number) => Place;
  /** On what is of glass, ink. */
  colour?: "ink";
}

/** One sees through what is of glass, and it throws no shadow. */
export type Colour = "ink" | "accent" | "brass" | "glass";

/** A part of a body, in body axes, z along axis 3. */
export type Piece =
  | { shape: "turned"; profile: [radius: number, z: number][]; colour: Colour }
  | { shape: "box"; size: Place; at?: Place; colour: Colour }
  | { shape: "rod"; from: Place; to: Place; radius: number; colour: Colour }
  /** The surface of a convex body: the point whose outward normal is given. */
  | { shape: "convex"; surface: (normal: Place) => Place; colour: Colour }
  | { shape: "stripe"; profile: [radius: number, z: number][] }
  /** The cone from the origin through a line. */
  | { shape: "fan"; points: Place[]; colour: Colour };

export type Scene = Flat | Solid;

/** A graph that has a name of its own: one quantity against another, on equal scales. */
export interface NamedGraph {
  title: Text;
  pair: [x: string, y: string];
}

/** A file beside this folder: the system's scene, others of its kind that show it in another way, and graphs with a name. */
export interface SceneFile {
  default: Scene;
  others?: { title: Text; scene: Scene }[];
  graphs?: NamedGraph[];
}
export type { Ink };

/** A ball of some radius, as a profile. */
export function ballProfile(radius: number, z = 0): [number, number][] {
  return Array.from({ length: 25 }, (_, k): [number, number] => {
    const angle = (k / 24) * Math.PI;
    return [radius * Math.sin(angle), z - radius * Math.cos(angle)];
  });
}

/** T's Euler angles R = Rz(psi) Rx(theta) Rz(phi) as a quaternion: geometry, no mechanics. */
export function turnOf(psi: number, theta: number, phi: number): Turn {
  const [s, c] = [Math.sin(theta / 2), Math.cos(theta / 2)];
  const [sum, difference] = [(psi + phi) / 2, (psi - phi) / 2];
  return [s * Math.cos(difference), s * Math.sin(difference), c * Math.sin(sum), c * Math.cos(sum)];
}
