// Whatever is typed gives a run or one sentence, the one of the command line; the core never breaks down.

import { describe, expect, it } from "vitest";
import { type Core, CoreError } from "../src/core";
import { BUILDS, load, scenario } from "./builds";

function sentence(core: Core, text: string): string {
  try {
    core.run(text).free();
  } catch (error) {
    if (error instanceof CoreError) return error.message;
    throw error;
  }
  return "";
}

const GOOD = scenario("pendulum", { method: '"rk4"', dt: 0.01, until: 1, every: 0.1 });
const MEBIBYTE = 1 << 20;

const SENTENCES: [string, string, string][] = [
  ["nothing", "", "the line 'precess = 1' is missing: it says which format this is"],
  ["an unknown system", GOOD.replace("pendulum", "pendulm"), "no system 'pendulm': did you mean 'pendulum'?"],
  ["an unknown method", GOOD.replace("rk4", "rk5"), "no method 'rk5': did you mean 'rk4'?"],
  ["broken TOML", GOOD.replace("[run]", "[run"), "line 5: "],
  ["no finite number", GOOD.replace("until = 1", "until = nan"), "line 8: 'nan' is not a finite number"],
  ["a step of zero", GOOD.replace("0.01", "0"), "dt must be above zero, not 0"],
  ["a run of years", GOOD.replace("0.01", "1e-99"), "would take years"],
  ["too many samples", GOOD.replace("0.1", "1e-8"), "do not fit into the memory of this page"],
  ["a wrong unit", GOOD.replace("until = 1", 'until = "1 kg"'), "a value in s is needed here, not one in kg"],
  ["characters that are none", `${GOOD}\u{d800}`, "line 10: "],
  ["more than a scenario may be", " ".repeat(MEBIBYTE + 1), "the text is longer than 1 MiB"],
  ["very much more", " ".repeat(200 * MEBIBYTE), "the text is longer than 1 MiB"],
];

/** Texts made to break a parser: deep, wide, long. */
const HOSTILE: [string, string][] = [
  ["deep arrays", `precess = ${"[".repeat(MEBIBYTE - 1000)}`],
  ["deep tables", `precess = ${"{a=".repeat(MEBIBYTE / 4)}`],
  ["deep dotted keys", `${"a.".repeat(MEBIBYTE / 2 - 10)}b = 1`],
  ["deep headers", `[${"a.".repeat(MEBIBYTE / 2 - 10)}b]`],
  ["a deep value", GOOD.replace("until = 1", `until = "${"(".repeat(MEBIBYTE - 1000)}"`)],
  ["a long name", GOOD.replace("pendulum", "pendulum".repeat(MEBIBYTE / 8 - 100))],
  ["a long number", GOOD.replace("until = 1", `until = ${"1".repeat(MEBIBYTE - 1000)}`)],
  ["many keys", Array.from({ length: 80_000 }, (_, k) => `k${k} = 1`).join("\n")],
  ["many tables", "[[event]]\n".repeat(100_000)],
  ["wide tables", `event = [${"{a.b.c.d.e.f.g.h.i.j.k=1},".repeat(MEBIBYTE / 26 - 1)}]`],
  ["many items", `precess = [${"1,".repeat(MEBIBYTE / 2 - 10)}]`],
  ["zeros", "\0".repeat(1000)],
];

describe.each(BUILDS)("%s", (build) => {
  it.each(SENTENCES)("answers %s with a sentence", async (_, text, expected) => {
    const core = await load(build);
    expect(sentence(core, text)).toContain(expected);
    expect(sentence(core, GOOD)).toBe("");
  });

  it.each(HOSTILE)("answers %s with one short line", async (_, text) => {
    const core = await load(build);
    const answer = sentence(core, text);
    expect(answer).not.toBe("");
    expect(answer).not.toContain("\n");
    expect(answer.length).toBeLessThan(300);
    expect(answer).not.toContain("1 MiB");
    expect(core.memory().size).toBeLessThan(1024 * MEBIBYTE);
    expect(sentence(core, GOOD)).toBe("");
  });

  it("survives any damage to its own scenarios", async () => {
    const core = await load(build);
    const random = generator(20260101);
    let understood = 0;
    for (const { text } of core.catalogue().scenarios) {
      for (let n = 0; n < 100; n++) {
        const at = random(text.length);
        const to = at + random(6);
        const damaged = text.slice(0, at) + String.fromCodePoint(random(1, 300)) + text.slice(to);
        let looks = 0;
        try {
          core.run(damaged, () => ++looks < 20).free();
          understood++;
        } catch (error) {
          expect(error, damaged).toBeInstanceOf(CoreError);
        }
      }
    }
    expect(understood).toBeGreaterThan(50);
  });
});

/** Whole numbers below a limit, the same ones every time (a linear congruential generator). */
function generator(seed: number): (low: number, high?: number) => number {
  let state = seed;
  return (low, high) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const [from, to] = high === undefined ? [0, low] : [low, high];
    return from + Math.floor((state / 2 ** 32) * (to - from));
  };
}
