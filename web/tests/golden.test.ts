// Both builds give the bits of golden/hashes.txt, the file that the native core is held against.

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import type { Core, Run } from "../src/core";
import { BUILDS, load, scenario } from "./builds";

const LINES = readFileSync(new URL("../../golden/hashes.txt", import.meta.url), "utf8")
  .split("\n")
  .filter((line) => line !== "" && !line.startsWith("#"));

/** The run that a golden line describes. */
function run(core: Core, line: string): Run {
  const [system = "", method = "", step = "", until = "", every = ""] = line.split(" ");
  const adaptive = core.catalogue().methods.find((card) => card.id === method)?.adaptive;
  return core.run(
    scenario(system, { method: `"${method}"`, [adaptive ? "rtol" : "dt"]: step, until, every }),
  );
}

/** SHA-256 of time and state as the facade hands them out: what the core says it hashed. */
function hashOfNumbers(run: Run, flip = false): string {
  const width = run.report.columns.length;
  const proper = run.report.columns.filter(({ kind }) => kind === "time" || kind === "state").length;
  const numbers = run.numbers.filter((_, k) => k % width < proper);
  if (flip) new Uint8Array(numbers.buffer).forEach((byte, k, all) => k === 8 && (all[k] = byte ^ 1));
  return createHash("sha256").update(numbers).digest("hex");
}

describe.each(BUILDS)("%s", (build) => {
  it("gives every golden hash", async () => {
    const core = await load(build);
    const wrong = LINES.filter((line) => {
      const done = run(core, line);
      const { failure } = done.report;
      const same = failure === null && done.hash() === line.split(" ")[5];
      done.free();
      return !same;
    });
    expect(wrong).toEqual([]);
    // Nothing is missing: the file knows every system and every method.
    const ids = (k: number) => new Set(LINES.map((line) => line.split(" ")[k]));
    expect(ids(0)).toEqual(new Set(core.catalogue().systems.map(({ id }) => id)));
    expect(ids(1)).toEqual(new Set(core.catalogue().methods.map(({ id }) => id)));
  });

  it("hands out the numbers that it hashes, and one wrong bit would be noticed", async () => {
    const core = await load(build);
    for (const line of LINES.filter((_, k) => k % 10 === 0)) {
      const done = run(core, line);
      expect(hashOfNumbers(done)).toBe(done.hash());
      expect(hashOfNumbers(done, true)).not.toBe(done.hash());
    }
    // The start moved by its last bit is another run.
    const of = (theta: string) =>
      core.run(scenario("pendulum", { until: 10, every: 1 }, `[start]\ntheta = ${theta}`)).hash();
    expect(of("1.0")).toBe(of("1"));
    expect(of("1.0000000000000002")).not.toBe(of("1"));
  });

  it("runs every scenario that comes with it as its report spells it out", async () => {
    const core = await load(build);
    for (const { file, text } of core.catalogue().scenarios) {
      const done = core.run(text);
      expect(done.report.failure, file).toBeNull();
      expect(core.run(done.report.scenario).hash(), file).toBe(done.hash());
    }
  });
});
