// What is freed is free, what is kept stays right while the memory moves, and what does not fit is refused.

import { describe, expect, it } from "vitest";
import { BUILDS, load, scenario } from "./builds";

const SHORT = scenario("double_pendulum", { until: 10, every: 0.01 });
const LONG = scenario("harmonic_oscillator", { method: '"rk4"', dt: 0.1, until: 1e5, every: 0.1 });

describe.each(BUILDS)("%s", (build) => {
  it("needs no more memory after a thousand runs than after one", async () => {
    const core = await load(build);
    const once = () => {
      core.run(SHORT).free();
      // A refusal may leak as well.
      expect(() => core.run("precess = 2")).toThrow();
    };
    once();
    const before = core.memory();
    for (let n = 0; n < 1000; n++) once();
    expect(core.memory()).toEqual(before);
    // The measure notices a run that is kept.
    core.run(SHORT);
    expect(core.memory().used).toBeGreaterThan(before.used + 1001 * 5 * 8);
  });

  it("hands out views that follow the memory when it grows", async () => {
    const core = await load(build);
    const short = core.run(SHORT);
    const before = short.column("theta1");
    const view = short.numbers;
    const { size } = core.memory();
    const long = core.run(LONG);
    expect(core.memory().size).toBeGreaterThan(size);
    expect(view.length).toBe(0);
    expect(short.column("theta1")).toEqual(before);
    expect(short.numbers.length).toBe(short.report.rows * short.report.columns.length);
    expect(long.report.rows).toBe(1_000_001);
    long.free();
    expect(short.column("theta1")).toEqual(before);
  });

  it("refuses the run that would fill the memory and goes on when room is made", async () => {
    const core = await load(build);
    const runs = [];
    let refusal = "";
    while (refusal === "" && runs.length < 100) {
      try {
        runs.push(core.run(LONG));
      } catch (error) {
        refusal = String(error);
      }
    }
    expect(refusal).toContain("do not fit into the memory of this page");
    for (const run of runs) run.free();
    expect(core.run(LONG).report.failure).toBeNull();
  });
});
