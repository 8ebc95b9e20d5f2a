import { expect, test } from "vitest";
import { fresh, toml, withValue } from "../src/lab/scenario";
import { asChoice, asMethod, chosenIn, PRINTED, printedIn } from "../src/lab/variation";
import { en } from "../src/words/en";
import { load } from "./builds";

const core = await load("precess");
const { systems, methods } = core.catalogue();

test("what a source prints is found on the cards, and stands beside what is right", () => {
  const having = systems.filter((system) => printedIn(system).length > 0);
  expect(having.map(({ id }) => id)).toEqual(
    expect.arrayContaining(["gyroscope_integrals", "rolling_top", "cluster"]),
  );
  for (const system of having) {
    const usual = fresh(system);
    for (const parameter of printedIn(system)) {
      const printed = asChoice(system.id, parameter, PRINTED).of(usual, undefined);
      if (!printed) throw new Error(`${system.id} ${parameter.name} runs as printed`);
      expect(chosenIn(printed, parameter)).toBe(PRINTED);
      expect(toml(printed)).toContain(`${parameter.name} = "as_printed"`);
      // The other way round it is the usual run.
      const back = asChoice(system.id, parameter, parameter.default);
      expect(back.of(usual, undefined)).toBeUndefined();
      expect(back.of(printed, undefined)).toEqual(usual);
      expect(asChoice("pendulum", parameter, PRINTED).of(usual, undefined)).toBeUndefined();
    }
  }
});

test("both are run by the core, and differ", () => {
  const system = systems.find(({ id }) => id === "gyroscope_integrals");
  const formula = printedIn(system).find(({ name }) => name === "formula_21");
  if (!system || !formula) throw new Error("no formula");
  const usual = { ...fresh(system), run: { until: "0.05", every: "0.01" } };
  const printed = asChoice(system.id, formula, PRINTED);
  expect(printed.title(en, "en")).toBe("formula_21 as printed");
  const hashes = [usual, printed.of(usual, undefined)].map((scenario) => {
    const run = core.run(toml(scenario ?? usual));
    const hash = run.hash();
    run.free();
    return hash;
  });
  expect(hashes[0]).not.toBe(hashes[1]);
});

test("a method is varied by a method", () => {
  const [one, other] = methods;
  const system = systems[0];
  if (!one || !other || !system) throw new Error("too few");
  const usual = withValue(fresh(system), "run", "until", "1");
  expect(asMethod(one).of(usual, one)).toBeUndefined();
  expect(asMethod(one).of(usual, other)).toMatchObject({ method: one.id, run: { until: "1" } });
});
