// How far a run can be trusted.

import { expect, test } from "vitest";
import { load, scenario } from "./builds";

const WILD = scenario(
  "double_pendulum",
  { method: '"rk4"', dt: 0.01, until: 20, every: 0.1 },
  "[start]\ntheta1 = 2\ntheta2 = 2\n",
);

test("a wild run is trusted for a while, in both builds alike", async () => {
  const tables = [];
  for (const build of ["precess", "precess-simd128"]) {
    const core = await load(build);
    const table = core.trust(WILD, 1e-3);
    expect(table.report.columns.map(({ name }) => name)).toEqual(["t", "error", "trusted"]);
    expect(table.report.failure).toBeNull();
    const [error, trusted] = [table.column("error"), table.column("trusted")];
    const horizon = trusted.indexOf(0);
    expect(horizon).toBeGreaterThan(10);
    expect(error[horizon]).toBeGreaterThan(1e-3);
    expect(Math.max(...error.subarray(0, horizon))).toBeLessThanOrEqual(1e-3);
    expect(trusted.subarray(horizon).every((one) => one === 0)).toBe(true);
    tables.push(table.numbers.slice());
    table.free();
    expect(() => table.numbers).toThrow("freed");
  }
  expect(tables[0]).toEqual(tables[1]);
});

test("a smooth run is trusted to its end, a tighter bound is met earlier", async () => {
  const core = await load("precess");
  const text = scenario("pendulum", { method: '"rk4"', dt: 0.01, until: 10, every: 0.5 });
  const count = (within: number) => core.trust(text, within).column("trusted").filter(Boolean).length;
  expect(count(1e-3)).toBe(21);
  expect(count(1e-12)).toBeLessThan(21);
});

test("it tells how far it is, can be ended, and says what it cannot do", async () => {
  const core = await load("precess");
  const shares: number[] = [];
  core.trust(WILD, 1e-3, (share) => shares.push(share) > 0);
  expect(shares.at(-1)).toBeGreaterThan(0.2);
  expect(() => core.trust(WILD, 1e-3, (share) => share === 0)).toThrow("interrupted");
  expect(() => core.trust(WILD, -1, undefined)).toThrow("above zero");
  expect(() => core.trust(scenario("noria", { until: 1 }), 1e-3)).toThrow(/shadow.*noria/);
});
