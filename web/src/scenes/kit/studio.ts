// Solid scenes: light, a soft shadow on a table, the body, the trace of its axis. Comes only when wanted.

import {
  AmbientLight,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  EdgesGeometry,
  Group,
  HemisphereLight,
  LatheGeometry,
  Line,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  ShadowMaterial,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from "three";
import type { Ink } from "../../draw/ink";
import type { Look } from "../../lab/result";
import { Crosses } from "./crosses";
import type { Colour, Path, Piece, Place, Solid } from "./scene";

/** For whatever else draws in three dimensions: the library then stays in one piece, and comes once. */
export { CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";

/** How the camera goes along: not at all, round with the axis, or with the body in all. */
export type View = "rest" | "axis" | "body";

/** What else stands in the scene; it is told the sample that is shown. */
export interface Overlay {
  readonly object: Object3D;
  show: (sample: number) => void;
}

/** The table's radius, in sizes: it fits into the picture. */
const TABLE = 1.2;
/** What is drawn on a body has to be seen on its ink and on its brass. */
const GOLD = "#f4cf6a";

export class Studio {
  readonly #renderer: WebGLRenderer;
  readonly #camera = new PerspectiveCamera(32, 1, 0.01, 100);
  #scene = new Scene();
  #body = new Group();
  /** Light and table. */
  #ground = new Group();
  #stripes: Mesh[] = [];
  #lines: Line[] = [];
  #crosses: Crosses | undefined;
  #look: Look | undefined;
  #solid: Solid | undefined;
  #overlay: Overlay | undefined;
  #size = 1;
  #centre: Place = [0, 0, 0];
  /** Where the camera stands: round, up, how far (in sizes). */
  round = -0.9;
  up = 0.36;
  far = 4.3;
  view: View = "rest";

  constructor(canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    this.#camera.up.set(0, 0, 1);
  }

  /** Builds everything for a run; the shapes are scaled so that the whole is of size one. */
  build(solid: Solid, look: Look, ink: Ink): void {
    this.#clear();
    if (solid !== this.#solid && solid.from) [this.round, this.up] = [solid.from.round, solid.from.up];
    const { size } = solid;
    [this.#solid, this.#look, this.#size] = [solid, look, size(look) || 1];
    this.#centre = this.#scaled(solid.centre?.(look) ?? [0, 0, 0]);
    const scene = new Scene();
    scene.add(
      new HemisphereLight(0xffffff, ink.dark ? 0x334466 : 0xd8c8b0, 1.6),
      new AmbientLight(0xffffff, 0.5),
    );
    const sun = new DirectionalLight(0xfff2dd, 2.6);
    sun.position.set(this.#centre[0] - 1.6, this.#centre[1] - 1.2, 4);
    sun.target.position.set(...this.#centre);
    sun.castShadow = true;
    sun.shadow.mapSize.set(1024, 1024);
    sun.shadow.radius = 6;
    Object.assign(sun.shadow.camera, { left: -2.5, right: 2.5, top: 2.5, bottom: -2.5, near: 0.5, far: 9 });
    this.#ground = new Group();
    this.#ground.add(sun, sun.target);
    scene.add(this.#ground);
    const table = solid.table?.(look);
    if (table !== undefined) this.#table(this.#ground, table / this.#size, ink);
    if (solid.sphere) this.#sphere(scene, solid.sphere(look) / this.#size, table, ink);
    this.#body = new Group();
    for (const piece of solid.body(look)) this.#body.add(...this.#piece(piece, ink));
    scene.add(this.#body);
    for (const piece of solid.still?.(look) ?? []) scene.add(...this.#piece(piece, ink));
    this.#scene = scene;
    const paths: Path[] = [{ on: "space", at: solid.trace }, ...(solid.paths ?? [])];
    this.#lines = paths.map((path) => {
      const plain = path.on === "body" ? GOLD : ink.accent;
      return this.#path(path, look, path.colour ? ink.ink : plain);
    });
  }

  /** Puts something into the scene, in place of what stood there. */
  dress(overlay: Overlay | undefined): void {
    if (this.#overlay) {
      this.#overlay.object.removeFromParent();
      release(this.#overlay.object);
    }
    this.#overlay = overlay;
    if (overlay) this.#scene.add(overlay.object);
  }

  #scaled([x, y, z]: Place): Place {
    return [x / this.#size, y / this.#size, z / this.#size];
  }

  #table(ground: Group, z: number, ink: Ink): void {
    const [x, y] = this.#centre;
    const top = new Mesh(
      new CircleGeometry(TABLE, 96),
      new MeshBasicMaterial({ color: ink.dark ? 0x18223a : 0xf1eee3 }),
    );
    const shadow = new Mesh(
      new CircleGeometry(TABLE, 96),
      new ShadowMaterial({ opacity: ink.dark ? 0.5 : 0.28 }),
    );
    top.position.set(x, y, z - 0.004);
    shadow.position.set(x, y, z - 0.002);
    shadow.receiveShadow = true;
    ground.add(top, shadow);
    // Rings would seem to rest where the table goes along.
    const rings = (this.#solid?.follow ? [1] : [0.25, 0.5, 0.75, 1]).map((share) => share * TABLE);
    for (const radius of rings) ground.add(ring(radius, [x, y, z], ink));
    this.#crosses = this.#solid?.follow ? new Crosses(TABLE, z, ink.faint) : undefined;
    if (this.#crosses) ground.add(this.#crosses.object);
  }

  #sphere(scene: Scene, radius: number, table: number | undefined, ink: Ink): void {
    const material = new MeshStandardMaterial({
      color: ink.faint,
      transparent: true,
      opacity: 0.07,
      side: DoubleSide,
      depthWrite: false,
    });
    // Of one that stands on a table only the upper half.
    const half = table === 0;
    const dome = new SphereGeometry(radius, 48, 32, 0, 2 * Math.PI, 0, half ? Math.PI / 2 : Math.PI);
    scene.add(new Mesh(dome.rotateX(Math.PI / 2), material));
    for (const z of [0, 0.5, 0.866]) scene.add(ring(radius * Math.sqrt(1 - z * z), [0, 0, radius * z], ink));
  }

  #piece(piece: Piece, ink: Ink): Object3D[] {
    if (piece.shape === "box") {
      const box = new BoxGeometry(...this.#scaled(piece.size));
      box.translate(...this.#scaled(piece.at ?? [0, 0, 0]));
      const edges = new LineSegments(
        new EdgesGeometry(box),
        new LineBasicMaterial({ color: ink.dark ? 0xffffff : 0x000000 }),
      );
      return [this.#solidOf(box, piece.colour, ink), edges];
    }
    if (piece.shape === "rod") {
      const [from, to] = [piece.from, piece.to].map((end) => new Vector3(...this.#scaled(end)));
      if (!from || !to || from.distanceTo(to) === 0) return [];
      const radius = piece.radius / this.#size;
      const rod = this.#solidOf(
        new CylinderGeometry(radius, radius, from.distanceTo(to), 16),
        piece.colour,
        ink,
      );
      rod.position.copy(from).add(to).multiplyScalar(0.5);
      rod.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), to.sub(from).normalize());
      return [rod];
    }
    if (piece.shape === "convex") return this.#convex(piece, ink);
    if (piece.shape === "fan") {
      const at = (k: number) => this.#scaled(piece.points[k] ?? [0, 0, 0]);
      const triangles = piece.points.slice(1).flatMap((_, k) => [0, 0, 0, ...at(k), ...at(k + 1)]);
      const fan = new BufferGeometry();
      fan.setAttribute("position", new BufferAttribute(new Float32Array(triangles), 3));
      fan.computeVertexNormals();
      return [this.#solidOf(fan, piece.colour, ink)];
    }
    const stripe = piece.shape === "stripe";
    const points = piece.profile.map(
      ([r, z]) => new Vector2((r / this.#size) * (stripe ? 1.006 : 1), z / this.#size),
    );
    const sectors: [number, number][] = stripe
      ? [0, 1, 2].map((k) => [(k * 2 * Math.PI) / 3, 0.42])
      : [[0, 2 * Math.PI]];
    return sectors.map(([from, angle]) => {
      const turned = new LatheGeometry(points, stripe ? 10 : 72, from, angle);
      turned.rotateX(Math.PI / 2);
      const mesh = this.#solidOf(turned, piece.shape === "stripe" ? "accent" : piece.colour, ink);
      if (stripe) this.#mark(mesh);
      return mesh;
    });
  }

  /** A convex body, with every fourth sector marked so that its spin can be seen. */
  #convex({ surface, colour }: Extract<Piece, { shape: "convex" }>, ink: Ink): Object3D[] {
    const part = (from: number, angle: number, paint: Colour, out: number) => {
      const sphere = new SphereGeometry(1, 96, 64, from, angle);
      const points = sphere.getAttribute("position");
      for (let k = 0; k < points.count; k++) {
        const [x, y, z] = this.#scaled(surface([points.getX(k), points.getY(k), points.getZ(k)]));
        points.setXYZ(k, x * out, y * out, z * out);
      }
      sphere.computeVertexNormals();
      return this.#solidOf(sphere, paint, ink);
    };
    if (colour === "glass") return [part(0, 2 * Math.PI, colour, 1)];
    const marks = [0, 1].map((k) => part(k * Math.PI - 0.12, 0.24, "accent", 1.004));
    marks.forEach((mark) => {
      this.#mark(mark);
    });
    return [part(0, 2 * Math.PI, colour, 1), ...marks];
  }

  /** What blurs when it goes round fast; it is drawn after what lies under it. */
  #mark(stripe: Mesh): void {
    (stripe.material as MeshStandardMaterial).transparent = true;
    this.#stripes.push(stripe);
  }

  #solidOf(geometry: BufferGeometry, colour: Colour, ink: Ink): Mesh {
    const glass = colour === "glass";
    const blue = ink.dark ? "#6d83b5" : "#33456b";
    const paints = { ink: blue, accent: ink.accent, brass: "#b08a3c", glass: blue };
    const material = new MeshStandardMaterial({
      color: new Color(paints[colour]),
      roughness: colour === "brass" ? 0.35 : 0.6,
      metalness: colour === "brass" ? 0.6 : 0.05,
      side: DoubleSide,
      transparent: glass,
      opacity: glass ? 0.2 : 1,
      depthWrite: !glass,
    });
    const mesh = new Mesh(geometry, material);
    mesh.castShadow = !glass;
    return mesh;
  }

  #path({ on, at }: Path, look: Look, colour: string): Line {
    const points = new Float32Array(look.times.length * 3);
    for (let k = 0; k < look.times.length; k++) points.set(this.#scaled(at(look, k)), 3 * k);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(points, 3));
    const line = new Line(geometry, new LineBasicMaterial({ color: colour }));
    line.frustumCulled = false;
    (on === "body" ? this.#body : this.#scene).add(line);
    return line;
  }

  /** Draws the moment of a sample; a body that has turned far since the last one shows its stripes blurred. */
  show(sample: number, spin: number): void {
    const [solid, look] = [this.#solid, this.#look];
    if (!solid || !look) return;
    const { place, turn } = solid.pose(look, sample);
    this.#body.position.set(...this.#scaled(place));
    this.#body.quaternion.set(...turn);
    if (solid.follow) {
      this.#centre = this.#scaled(place);
      this.#ground.position.set(this.#centre[0], this.#centre[1], 0);
      this.#crosses?.show(this.#centre[0], this.#centre[1]);
    }
    const blur = Math.min(Math.max((spin - 0.6) / 1.4, 0), 1);
    for (const stripe of this.#stripes) (stripe.material as MeshStandardMaterial).opacity = 1 - 0.8 * blur;
    // Not all of a long path: the newest part of it.
    const from = Math.max(0, sample - 2400);
    for (const line of this.#lines) line.geometry.setDrawRange(from, sample - from + 1);
    const canvas = this.#renderer.domElement;
    const [w, h] = [canvas.clientWidth, canvas.clientHeight];
    if (w === 0 || h === 0) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.setSize(w, h, false);
    this.#overlay?.show(sample);
    this.#aim(this.far * Math.max(1, h / w));
    this.#camera.aspect = w / h;
    this.#camera.updateProjectionMatrix();
    this.#renderer.render(this.#scene, this.#camera);
  }

  /** Points the camera at the middle, from so far away. */
  #aim(far: number): void {
    const { position, quaternion } = this.#body;
    const body = this.view === "body";
    const axis = new Vector3(0, 0, 1).applyQuaternion(quaternion);
    const round = this.round + (this.view === "axis" ? Math.atan2(axis.y, axis.x) : 0);
    const from = new Vector3(
      Math.cos(this.up) * Math.sin(round),
      -Math.cos(this.up) * Math.cos(round),
      Math.sin(this.up),
    ).multiplyScalar(far);
    const centre = new Vector3(...this.#centre);
    // A body that goes about is seen with its table, from edge to edge.
    if (this.#solid?.follow && !body) centre.z *= 0.6;
    this.#camera.up.set(0, 0, 1);
    if (body) {
      // Whoever rides on the body sees the world turn about its middle.
      if (!this.#solid?.follow) centre.sub(position).applyQuaternion(quaternion).add(position);
      from.applyQuaternion(quaternion);
      this.#camera.up.copy(axis);
    }
    this.#camera.position.copy(centre).add(from);
    this.#camera.lookAt(centre);
  }

  #clear(): void {
    this.#stripes = [];
    this.#overlay = undefined;
    release(this.#scene);
  }

  dispose(): void {
    this.#clear();
    this.#renderer.dispose();
  }
}

/** Gives back what the graphics card holds of something. */
function release(all: Object3D): void {
  all.traverse((object) => {
    if (object instanceof Mesh || object instanceof Line) {
      (object.geometry as BufferGeometry).dispose();
      (object.material as MeshStandardMaterial).dispose();
    }
  });
}

function ring(radius: number, [x, y, z]: Place, ink: Ink): Line {
  const points = Array.from({ length: 97 }, (_, k) =>
    new Vector2(radius, 0).rotateAround(new Vector2(), (k * Math.PI) / 48),
  );
  const line = new Line(
    new BufferGeometry().setFromPoints(points),
    new LineBasicMaterial({ color: ink.faint, transparent: true, opacity: 0.35 }),
  );
  line.position.set(x, y, z);
  return line;
}
