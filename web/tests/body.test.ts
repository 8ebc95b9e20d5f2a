// Bodies that are drawn: kept in the scenario, understood by the core.

import { expect, test } from "vitest";
import { bodyIn, hasBody, outline, withBody, type Drawn } from "../src/lab/body";
import { toml, type Scenario } from "../src/lab/scenario";
import { scenarioOf } from "../src/lab/toml";
import { lookAt } from "./looks";

const TOP: Drawn = { height: 0.06, density: 700, radii: [0.002, 0.02, 0.028, 0.01, 0.004] };
const BARREL: Drawn = { ...TOP, radii: [0.01, 0.02, 0.022, 0.02, 0.01] };
const of = (system: string, parameters = {}, rest = ""): Scenario => ({
  ...{ title: "", label: "", system, parameters, start: {}, method: "", rest },
  run: { until: "0.1", every: "0.05" },
});

test("a drawn body goes into the scenario and comes out of it", () => {
  const watched = of("heavy_top", { m: "2", g: "9.8" }, '[[event]]\nname = "it"\nwhen = "qx = 0"');
  const scenario = withBody(watched, TOP);
  // What the body gives is no parameter any more; gravity stays.
  expect(scenario.parameters).toEqual({ g: "9.8" });
  const read = scenarioOf(toml(scenario));
  expect(bodyIn(read)).toEqual(TOP);
  expect(read.rest).toContain("[[event]]");
  expect(bodyIn(withBody(read, BARREL))).toEqual(BARREL);
  const without = withBody(read, undefined);
  expect(hasBody(without)).toBe(false);
  expect(without.rest).toBe(watched.rest);
  // One that is written in another way is not understood, but noticed.
  const other = of("rolling_body", {}, '[system.body]\nshape = "sphere"\nradius = 1\n');
  expect([bodyIn(other), hasBody(other)]).toEqual([undefined, true]);
});

test("the core makes a heavy top of it, about its lower end", () => {
  const look = lookAt(toml(withBody(of("heavy_top"), TOP)));
  const [x, y, z] = look.list("centre").map(([c]) => c);
  expect([x, y]).toEqual([0, 0]);
  expect(z).toBeGreaterThan(0.015);
  expect(z).toBeLessThan(0.035);
  expect(look.parameter("i1")).toBe(look.parameter("i2"));
  // By slices, roughly.
  const slice = TOP.height / 5;
  const sum = TOP.radii.reduce((total, r) => total + r * r, 0);
  expect(look.parameter("m") / (700 * Math.PI * slice * sum)).toBeCloseTo(1, 0);
});

test("on a table a hollow one is refused with the core's sentence, a convex one rolls", () => {
  expect(() => lookAt(toml(withBody(of("sliding_body"), TOP)))).toThrow(/hollow at radius 4.*convex/);
  const look = lookAt(toml(withBody(of("rolling_body"), BARREL)));
  expect(look.parameter("point3")).toBeCloseTo(-0.03, 12);
});

test("an outline begins and ends on the axis", () => {
  const line = outline(TOP, -0.01);
  expect(line[0]).toEqual([0, -0.01]);
  expect(line.at(-1)?.[0]).toBe(0);
  expect(line.at(-1)?.[1]).toBeCloseTo(0.05, 15);
  expect(line).toHaveLength(TOP.radii.length + 4);
});
