import { expect, test } from "vitest";
import { columnsOf } from "../src/lab/columns";
import { energiesOf, rangeOf } from "../src/lab/energies";
import { Look } from "../src/lab/result";
import { fresh, toml } from "../src/lab/scenario";
import { load } from "./builds";

const core = await load("precess");
const { systems } = core.catalogue();

function shown(id: string) {
  const system = systems.find((one) => one.id === id);
  if (!system) throw new Error(`no ${id}`);
  const scenario = fresh(system);
  const run = core.run(toml(scenario));
  const look = new Look({
    scenario,
    report: run.report,
    hash: run.hash(),
    events: [],
    numbers: columnsOf(run),
  });
  run.free();
  return { look, names: energiesOf(system, look) };
}

test("energies come as the card names them, the total last, which the others add up to", () => {
  for (const id of ["pendulum", "heavy_top", "elastic_pendulum", "tippe_top"]) {
    const { look, names } = shown(id);
    expect(names, id).toEqual(["kinetic", "potential", "energy"]);
    const [low, high] = rangeOf(look, names);
    for (const sample of [0, look.times.length - 1]) {
      const [kinetic = NaN, potential = NaN, energy = NaN] = names.map((name) => look.at(name, sample));
      expect(Math.abs(kinetic + potential - energy)).toBeLessThan(1e-12 * (high - low));
      for (const x of [0, kinetic, potential, energy]) expect(x >= low && x <= high).toBe(true);
    }
  }
});

test("one energy alone is no picture", () => {
  expect(shown("double_pendulum").names).toEqual([]);
  expect(shown("lorenz").names).toEqual([]);
});
