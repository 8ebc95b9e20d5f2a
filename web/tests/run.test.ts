// What the facade makes of a run: columns, events, drifts, progress, errors of use.

import { describe, expect, it, test } from "vitest";
import { Core } from "../src/core";
import first from "../src/first.toml?raw";
import { BUILDS, load, scenario } from "./builds";

const PENDULUM = scenario("pendulum", { method: '"dop853"', until: 10, every: 0.5 });

describe.each(BUILDS)("%s", (build) => {
  it("gives columns with names, units and kinds", async () => {
    const run = (await load(build)).run(PENDULUM);
    const { columns, rows } = run.report;
    expect(columns.slice(0, 3)).toEqual([
      { name: "t", unit: "s", kind: "time" },
      { name: "theta", unit: "rad", kind: "state" },
      { name: "theta_dot", unit: "rad/s", kind: "state" },
    ]);
    expect(columns.map(({ kind }) => kind)).toContain("invariant");
    expect(rows).toBe(21);
    expect(run.column("t")).toEqual(Float64Array.from({ length: 21 }, (_, k) => k * 0.5));
    expect(run.column("theta")[0]).toBe(1);
    expect(() => run.column("thetta")).toThrow("no column thetta");
  });

  it("tells where a result comes from and how far its invariants drift", async () => {
    const { report } = (await load(build)).run(PENDULUM);
    expect(report.scenario).toContain('method = "dop853"');
    expect(report.scenario_hash).toMatch(/^[0-9a-f]{64}$/);
    expect(report.evaluations).toBeGreaterThan(report.steps);
    expect(report.drifts.map(({ name }) => name)).toEqual(["energy"]);
    expect(report.drifts[0]?.relative).toBeLessThan(1e-8);
    expect(report.drifts[0]?.relative).toBeGreaterThan(0);
  });

  it("gives the events that were met", async () => {
    const core = await load(build);
    const run = core.run(`${PENDULUM}[[event]]\nname = "down"\nwhen = "theta = 0"\n`);
    const events = run.events();
    expect(events.length).toBeGreaterThan(5);
    for (const { name, t, state } of events) {
      expect(name).toBe("down");
      expect(t).toBeGreaterThan(0);
      expect(state.length).toBe(2);
      expect(Math.abs(state[0] ?? NaN)).toBeLessThan(1e-12);
    }
    expect(run.report.event_texts).toEqual([null]);
    const stopped = core.run(`${PENDULUM}[[event]]\nname = "down"\nwhen = "theta = 0"\nstop = true\n`);
    expect(stopped.report.stopped_by).toBe("down");
    expect(stopped.column("t").at(-1)).toBe(events[0]?.t);
  });

  it("says in a sentence why a run failed, and keeps its samples", async () => {
    const run = (await load(build)).run(
      scenario("gyroscope", { method: '"euler"', dt: 0.5, until: 1000, every: 0.5 }),
    );
    expect(run.report.failure).toMatch(/the state is no longer finite after t = /);
    expect(run.report.rows).toBeGreaterThan(0);
  });

  it("tells how far a run has come, and ends it", async () => {
    const core = await load(build);
    const long = scenario("pendulum", { method: '"rk4"', dt: 0.001, until: 1e9, every: 1e6 });
    const times: number[] = [];
    const run = core.run(long, (t) => times.push(t) < 10);
    expect(times.length).toBe(10);
    expect(times).toEqual([...times].sort((a, b) => a - b));
    expect(run.report.failure).toMatch(/^interrupted at t = /);
    const { used } = core.memory();
    const throws = () => {
      throw new Error("enough");
    };
    expect(() => core.run(long, throws)).toThrow("enough");
    expect(core.memory().used).toBeLessThanOrEqual(used);
    // The core may be called in between.
    let inner = "";
    const outer = core.run(PENDULUM, () => {
      inner ||= core.run(PENDULUM).hash();
      return true;
    });
    expect(inner).toBe(outer.hash());
  });

  it("notices a run that has been freed", async () => {
    const core = await load(build);
    const run = core.run(PENDULUM);
    run.free();
    run.free();
    expect(() => run.numbers).toThrow("freed");
    expect(() => run.hash()).toThrow("freed");
    expect(() => run.events()).toThrow("freed");
    const other = core.run(PENDULUM);
    expect(other.hash()).toMatch(/^[0-9a-f]{64}$/);
  });
});

it("refuses a module that is no core", async () => {
  const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  await expect(Core.load(empty)).rejects.toThrow("no Precess core");
});

test("the small core runs the first page, bit by bit as the whole one does", async () => {
  const [small, whole] = await Promise.all([load("precess-first"), load("precess")]);
  const run = small.run(first);
  expect(run.report.rows).toBeGreaterThan(1000);
  expect(run.hash()).toBe(whole.run(first).hash());
  expect(() => small.run(scenario("pendulum", {}))).toThrow("no system 'pendulum'");
  expect(() => small.ensemble(first, { names: ["theta"], values: [1] })).toThrow("no ensembles");
});
