import { expect, test } from "vitest";
import { SvgBrush } from "../src/draw/svg";
import type { Look } from "../src/lab/result";
import { fresh, toml } from "../src/lab/scenario";
import { potential } from "../src/scenes/henon_heiles";
import { road } from "../src/scenes/car_suspension";
import { wire } from "../src/scenes/bead_on_curve";
import { chain } from "../src/scenes/n_pendulum";
import { Pen } from "../src/scenes/kit/pen";
import { turnOf, type Place, type Scene } from "../src/scenes/kit/scene";
import { axis, usual } from "../src/scenes/kit/usual";
import { polynomial } from "../src/scenes/kit/landscape";
import { cones, ellipsoid, product, upright } from "../src/scenes/kit/poinsot";
import { supportOf, surface, turned } from "../src/scenes/kit/table";
import { largest, vectorsOf } from "../src/scenes/kit/vectors";
import { load } from "./builds";
import { ink, lookAt } from "./looks";

const core = await load("precess");
const { systems, scenarios } = core.catalogue();
const files = import.meta.glob<{ default: Scene }>("../src/scenes/*.ts", { eager: true });
const pictures = Object.keys(import.meta.glob("../src/thumbnails/*.webp"));
const sceneOf = (id: string) => files[`../src/scenes/${id}.ts`]?.default;

function systemOf(id: string) {
  const system = systems.find((one) => one.id === id);
  if (!system) throw new Error(id);
  return system;
}
const usualRun = (id: string) => lookAt(toml(fresh(systemOf(id))));

/** Draws a flat scene as SVG; a number that is none would stand in it. */
function drawn(scene: Extract<Scene, { kind: "flat" }>, look: Look, sample: number): string {
  const brush = new SvgBrush();
  scene.draw(new Pen(brush, 600, 400, scene.reach(look), ink, scene.centre?.(look)), look, sample);
  return brush.elements;
}

test("every scene and every picture belongs to a system", () => {
  const ids = systems.map(({ id }) => id);
  const named = (path: string) => path.replace(/.*\/|\.\w+$/g, "");
  for (const path of [...Object.keys(files), ...pictures]) expect(ids).toContain(named(path));
});

test("every system has a scene and a picture of its own", () => {
  for (const { id } of systems) {
    expect(sceneOf(id), id).toBeDefined();
    expect(pictures, id).toContain(`../src/thumbnails/${id}.webp`);
  }
});

test("what touches on the body lies where it touches on the table", () => {
  const touching = systems.filter(({ id }) => {
    const scene = sceneOf(id);
    return scene?.kind === "solid" && scene.follow && scene.paths !== undefined;
  });
  expect(touching.length).toBeGreaterThanOrEqual(11);
  for (const { id } of touching) {
    const [look, scene] = [usualRun(id), sceneOf(id)];
    if (scene?.kind !== "solid") continue;
    const size = scene.size(look);
    for (const sample of [0, look.times.length >> 2, look.times.length >> 1]) {
      const { place, turn } = scene.pose(look, sample);
      const [on] = scene.paths ?? [];
      const [dx, dy, dz] = turned(turn, on?.at(look, sample) ?? [NaN, NaN, NaN]);
      const [x, y] = scene.trace(look, sample);
      // A little outside the body, so that it is seen.
      for (const apart of [place[0] + dx - x, place[1] + dy - y, place[2] + dz])
        expect(Math.abs(apart), id).toBeLessThan(0.01 * size);
    }
  }
});

test.each(systems.map(({ id }) => id))("%s is drawn, moves, and is drawn by the usual scene too", (id) => {
  const look = usualRun(id);
  const last = look.times.length - 1;
  for (const scene of [sceneOf(id), usual(look)]) {
    if (!scene) continue;
    const [one, other] = [Math.round(last * 0.2), Math.round(last * 0.63)];
    if (scene.kind === "flat") {
      const drawings = [0, one, other, last].map((sample) => drawn(scene, look, sample));
      for (const drawing of drawings) {
        expect(drawing).toContain("<path");
        expect(drawing).not.toMatch(/NaN|Infinity|undefined/);
      }
      expect(drawings[1]).not.toBe(drawings[2]);
      continue;
    }
    expect(scene.size(look)).toBeGreaterThan(0);
    expect(scene.body(look).length).toBeGreaterThan(0);
    for (const sample of [0, one, other, last]) {
      const { place, turn } = scene.pose(look, sample);
      for (const x of [...place, ...turn, ...scene.trace(look, sample)]) expect(x).toSatisfy(Number.isFinite);
      // A run keeps the length of a quaternion to its tolerance.
      expect(Math.hypot(...turn)).toBeCloseTo(1, 5);
    }
    expect(scene.pose(look, one)).not.toEqual(scene.pose(look, other));
  }
});

test.each(scenarios.map(({ file, text }) => ({ file, text })))("$file is drawn", ({ text }) => {
  const look = lookAt(text);
  const id = look.whole.system;
  const scene = sceneOf(id) ?? usual(look);
  if (scene.kind === "flat") expect(drawn(scene, look, look.times.length >> 1)).not.toMatch(/NaN|Infinity/);
  else expect(scene.size(look)).toBeGreaterThan(0);
});

/** Largest difference over a run between what a scene draws and what the core computed. */
function difference(look: Look, name: string, drawn: (k: number) => number): number {
  return look.column(name).reduce((worst, x, k) => Math.max(worst, Math.abs(x - drawn(k))), 0);
}

test("the shapes are the core's own", () => {
  const well = usualRun("potential_well");
  const u = polynomial(well.list("u").map(([c = 0]) => c));
  expect(difference(well, "potential", (k) => u(well.at("x", k)))).toBeLessThan(1e-14);
  const cubic = usualRun("cubic_well");
  expect(
    difference(cubic, "potential", (k) => polynomial([0, 0, 1 / 2, -1 / 3])(cubic.at("x", k))),
  ).toBeLessThan(1e-14);
  const duffing = usualRun("duffing");
  const valleys = polynomial([0, 0, duffing.parameter("alpha") / 2, 0, duffing.parameter("beta") / 4]);
  expect(difference(duffing, "potential", (k) => valleys(duffing.at("x", k)))).toBeLessThan(1e-14);
  const bead = usualRun("bead_on_curve");
  expect(difference(bead, "y", (k) => wire(bead)(bead.at("x", k)))).toBeLessThan(1e-13);
  const galaxy = usualRun("henon_heiles");
  expect(
    difference(galaxy, "potential", (k) => potential(galaxy)(galaxy.at("x", k), galaxy.at("y", k))),
  ).toBeLessThan(1e-14);
  const car = usualRun("car_suspension");
  expect(difference(car, "road", (k) => road(car, k)(0))).toBeLessThan(1e-13);
  const rods = usualRun("n_pendulum");
  expect(difference(rods, "y", (k) => chain(rods, k).at(-1)?.[1] ?? NaN)).toBeLessThan(1e-13);
});

test("bodies point where the core says", () => {
  for (const [id, names] of [
    ["gyroscope", ["axis_x", "axis_y", "axis_z"]],
    ["heavy_top", ["axis_x", "axis_y", "axis_z"]],
    ["free_body", ["axis_x", "axis_y", "axis_z"]],
    ["spherical_pendulum", ["x", "y", "z"]],
  ] as const) {
    const [look, scene] = [usualRun(id), sceneOf(id)];
    if (scene?.kind !== "solid") throw new Error(id);
    const last = look.times.length - 1;
    for (const sample of [0, last >> 2, last >> 1, last]) {
      const points = turned(scene.pose(look, sample).turn, [0, 0, 1]);
      names.forEach((name, k) => {
        expect(points[k], `${id} ${name}`).toBeCloseTo(look.at(name, sample), 6);
      });
      if (look.has("qw")) expect(axis(look, sample)[2]).toBeCloseTo(look.at("axis_z", sample), 6);
    }
  }
});

test("the polhode rolls on the herpolhode, which lies in the invariable plane", () => {
  const look = usualRun("free_body");
  const last = look.times.length - 1;
  const up = upright(look);
  const l: Place = [look.at("Lx", 0), look.at("Ly", 0), look.at("Lz", 0)];
  expect(turned(up, l)[2]).toBeCloseTo(Math.hypot(...l), 12);
  const [once, twice] = [turned(product(up, up), l), turned(up, turned(up, l))];
  once.forEach((x, axis) => {
    expect(x).toBeCloseTo(twice[axis] ?? NaN, 12);
  });
  for (const scene of [ellipsoid, cones]) {
    const [polhode] = scene.paths ?? [];
    const heights: number[] = [];
    for (let k = 0; k <= last; k += 97) {
      const touch = turned(scene.pose(look, k).turn, polhode?.at(look, k) ?? [NaN, NaN, NaN]);
      const there = scene.trace(look, k);
      // Both are drawn off by a little, so that they are seen: the plane's by a fixed length, the body's by a share.
      const off = 0.004 + 0.002 * Math.hypot(...touch) + 1e-6;
      touch.forEach((x, axis) => {
        expect(Math.abs(x - (there[axis] ?? NaN))).toBeLessThan(off);
      });
      heights.push(there[2]);
    }
    expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(1e-7);
    const momentum = vectorsOf(scene, look).find(({ name }) => name === "momentum");
    expect(momentum?.by(last)[2]).toBeCloseTo(Math.hypot(...l), 7);
    if (scene.table) expect(heights[0]).toBeCloseTo(scene.table(look) ?? NaN, 2);
  }
});

test("a body touches the table where the core says, and hangs together", () => {
  const touching = systems.filter(({ observables }) => observables.some(({ name }) => name === "contact3"));
  for (const { id } of touching) {
    const look = usualRun(id);
    const shape = surface(supportOf(look));
    for (const sample of [0, look.times.length >> 1]) {
      const [x, y, z, w] = ["qx", "qy", "qz", "qw"].map((name) => look.at(name, sample)) as [
        number,
        number,
        number,
        number,
      ];
      // Downwards, in body axes.
      const touch = shape(turned([-x, -y, -z, w], [0, 0, -1]));
      ["contact1", "contact2", "contact3"].forEach((name, k) => {
        expect(touch[k], `${id} ${name}`).toBeCloseTo(look.at(name, sample), 6);
      });
    }
  }
  // An ellipsoid, a ball and a shifted point by hand.
  const shape = surface({ point: [0, 0, 0.1], radius: 0.5, axes: [3, 2, 1] });
  const normal: Place = [0, 0.6, 0.8];
  const reach = Math.hypot(2 * 0.6, 0.8);
  expect(shape(normal)).toEqual([0, 0.3 + (4 * 0.6) / reach, 0.1 + 0.4 + 0.8 / reach]);
});

test("vectors are the core's own", () => {
  const of = (id: string, name: string) => {
    const [look, scene] = [usualRun(id), sceneOf(id)];
    const solid = scene ?? usual(look);
    if (solid.kind !== "solid") throw new Error(id);
    const vector = vectorsOf(solid, look).find((one) => one.name === name);
    if (!vector) throw new Error(`${id} has no ${name}`);
    return { look, vector };
  };
  const samples = (look: Look) =>
    [0, 0.21, 0.5, 0.93].map((share) => Math.round(share * (look.times.length - 1)));
  // A free body tells its angular velocity and momentum along the axes of space.
  for (const [name, columns] of [
    ["omega", ["omega_x", "omega_y", "omega_z"]],
    ["momentum", ["Lx", "Ly", "Lz"]],
  ] as const) {
    const { look, vector } = of("free_body", name);
    for (const sample of samples(look))
      columns.forEach((column, k) => {
        expect(vector.by(sample)[k], column).toBeCloseTo(look.at(column, sample), 6);
      });
  }
  // A top tells its angular velocity in its own frame; by the rates of its angles it is the same.
  const { look, vector } = of("gyroscope", "omega");
  const momentum = of("gyroscope", "momentum").vector;
  for (const sample of samples(look)) {
    const [psi, theta] = [look.at("psi", sample), look.at("theta", sample)];
    const [a, b, c] = ["psi_dot", "theta_dot", "phi_dot"].map((name) => look.at(name, sample)) as Place;
    const [s, q] = [Math.sin(theta), Math.cos(theta)];
    const rates = [
      b * Math.cos(psi) + c * s * Math.sin(psi),
      b * Math.sin(psi) - c * s * Math.cos(psi),
      a + c * q,
    ];
    const size = Math.hypot(...rates);
    vector.by(sample).forEach((x, k) => {
      expect((x - (rates[k] ?? NaN)) / size).toBeCloseTo(0, 9);
    });
    const l = momentum.by(sample);
    expect(Math.hypot(...l) / look.at("L_A", sample)).toBeCloseTo(1, 9);
    expect(l[2] / look.at("L_Az", sample)).toBeCloseTo(1, 6);
    // Of a symmetric top axis, angular velocity and momentum lie in a plane, the last two on the same side.
    const [axis, omega] = [turned(turnOf(psi, theta, 0), [0, 0, 1]), vector.by(sample)];
    const across = (v: Place): Place => {
      const along = v.reduce((sum, x, k) => sum + x * (axis[k] ?? 0), 0);
      return v.map((x, k) => (x - along * (axis[k] ?? 0)) / Math.hypot(...v)) as Place;
    };
    const [p, r] = [across(omega), across(l)];
    const same = p.reduce((sum, x, k) => sum + x * (r[k] ?? 0), 0);
    expect(same).toBeCloseTo(Math.hypot(...p) * Math.hypot(...r), 9);
  }
  // A symmetric body tells both ways.
  const free = of("symmetric_body", "momentum");
  expect(Math.hypot(...free.vector.by(7)) / free.look.at("L", 7)).toBeCloseTo(1, 9);
  // Whatever is shown of whichever body is a number.
  for (const { id } of systems) {
    const run = usualRun(id);
    const solid = sceneOf(id) ?? usual(run);
    if (solid.kind !== "solid") continue;
    for (const one of vectorsOf(solid, run)) {
      expect(largest(one, run), `${id} ${one.name}`).toBeGreaterThanOrEqual(0);
      for (const x of [...one.by(3), ...one.from(3)])
        expect(x, `${id} ${one.name}`).toSatisfy(Number.isFinite);
    }
  }
});
