import { expect, test } from "vitest";
import { tiles } from "../src/core/tiles";
import { CELL, colourOf, patternOf, Raster, rgb } from "../src/draw/raster";
import { nearestRow, placesOf, rowsIn, withPlace } from "../src/lab/places";
import { fresh, toml } from "../src/lab/scenario";
import { load } from "./builds";

const core = await load("precess");
const system = core.catalogue().systems.find(({ id }) => id === "magnetic_pendulum");
if (!system) throw new Error("no magnets");

const axes = (points: number) => ["x", "y"].map((name) => ({ name, low: 0, high: points - 1, points }));
/** A value that tells where it belongs. */
const told = (i: number, j: number) => i + 100 * j;

test("a picture is whole after the first tiles, and right after the last", () => {
  const raster = new Raster(40);
  const dye = { low: 0, high: told(39, 39) };
  let tile = 0;
  for (const part of tiles(axes(40), 8, 16)) {
    const [a, b] = part.map(({ part }) => part);
    if (!a || !b) throw new Error("no tile");
    const values = Array.from({ length: a.points * b.points }, (_, k) =>
      told(a.first + a.stride * (k % a.points), b.first + b.stride * Math.floor(k / a.points)),
    );
    raster.take(part, values);
    if (++tile === 1) {
      const pixels = raster.pixels(dye, 1);
      for (let k = 3; k < pixels.length; k += 4) expect(pixels[k]).toBe(255);
      expect(raster.own().length).toBe(25);
    }
  }
  expect(raster.known).toBe(1600);
  const pixels = raster.pixels(dye, 1);
  for (const [i, j] of [
    [0, 0],
    [39, 0],
    [17, 22],
    [1, 39],
  ] as const) {
    const at = 4 * ((39 - j) * 40 + i);
    expect([...pixels.subarray(at, at + 4)]).toEqual([...colourOf(dye, told(i, j)), 255]);
  }
  expect(raster.range()).toEqual([16, told(23, 39)]);
});

test("a draft is seen until the values come, and is not known", () => {
  const raster = new Raster(8);
  const [coarse, ...others] = tiles(axes(8), 4, 8);
  if (!coarse) throw new Error("no tile");
  const dye = { kinds: [[1, 1, 1] as const, [2, 2, 2] as const] };
  const seen = () => new Set(raster.pixels(dye, 1).filter((_, k) => k % 4 === 0));
  raster.take(coarse, new Float64Array(4).fill(1), true);
  expect([raster.known, raster.taken, raster.own().length]).toEqual([0, 4, 0]);
  expect(seen()).toEqual(new Set([2]));
  for (const tile of [coarse, ...others]) {
    const points = tile.reduce((all, { part }) => all * (part?.points ?? NaN), 1);
    raster.take(tile, new Float64Array(points).fill(0));
  }
  expect([raster.known, raster.own().length]).toEqual([64, 64]);
  expect(seen()).toEqual(new Set([1]));
});

test("patterns tell kinds apart without their colours, and a range by how dense they are", () => {
  const ink = (dye: Parameters<typeof patternOf>[0], value: number) => {
    const pattern = patternOf(dye, value);
    return Array.from({ length: 72 * 72 }, (_, k) => Number(pattern(k % 72, Math.floor(k / 72))));
  };
  const kinds = { kinds: [0, 1, 2, 3, 4].map((k): [number, number, number] => [k, k, k]) };
  const drawings = kinds.kinds.map((_, k) => ink(kinds, k));
  expect(new Set(drawings.map((drawing) => drawing.join(""))).size).toBe(5);
  const density = [0.1, 0.3, 0.5, 0.7, 0.9].map((x) => ink({ low: 0, high: 1 }, x).reduce((a, b) => a + b));
  expect(density).toEqual(density.toSorted((a, b) => a - b));
  const raster = new Raster(8);
  raster.take(axes(8), new Float64Array(64).fill(4));
  const patterned = raster.pixels(
    {
      kinds: [
        [0, 0, 0],
        [0, 0, 0],
        [0, 0, 0],
        [0, 0, 0],
        [9, 9, 9],
      ],
    },
    CELL,
  );
  expect(new Set(patterned).size).toBeGreaterThan(2);
  expect(rgb("#1d3f7a")).toEqual([0x1d, 0x3f, 0x7a]);
});

test("magnets are found on the card, moved in the scenario, and told by which is nearest", () => {
  const places = placesOf(system);
  if (!places) throw new Error("no places");
  expect(places).toMatchObject({ parameter: "magnets", fields: ["x", "y", "strength"], names: ["x", "y"] });
  expect(rowsIn(fresh(system), undefined, places).length).toBe(3);
  expect(
    core
      .catalogue()
      .systems.filter((one) => placesOf(one))
      .map(({ id }) => id),
  ).toEqual([system.id]);
  const rows = [
    [0.5, 0, 1],
    [-0.25, 0.4, 2],
  ];
  const moved = withPlace(fresh(system), places, rows, 1, { x: 0.125, y: -1 });
  expect(moved.parameters["magnets"]).toBe("[[0.5; 0; 1]; [0.125; -1; 2]]");
  expect(rowsIn(moved, undefined, places)).toEqual([
    [0.5, 0, 1],
    [0.125, -1, 2],
  ]);
  // What only the core can read is left to it.
  const odd = { ...moved, parameters: { magnets: "[[1/2; 0; 1]]" } };
  expect(rowsIn(odd, undefined, places)).toEqual([]);
  const run = core.run(toml({ ...moved, run: { until: "1", every: "1" } }));
  expect(run.report.scenario).toContain("-1");
  run.free();
  const nearest = nearestRow(places, rows, [Float64Array.of(0.4, -1, NaN), Float64Array.of(0, 0.3, 0)]);
  expect([...nearest]).toEqual([0, 1, NaN]);
});
