// Where starts end, proved: the golden map, tiles, sentences.

import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { type Axis, CoreError, place, tiles } from "../src/core";
import { BUILDS, load } from "./builds";

const MAGNETS = `precess = 1
[system]
id = "magnetic_pendulum"
[system.parameters]
c = 4
r = 0.2
d = 0.1
[start]
y_dot = 0
`;
const GOLDEN = readFileSync(new URL("../../golden/basins.txt", import.meta.url), "utf8")
  .trim()
  .split("\n");
const AXES: Axis[] = ["x", "y"].map((name) => ({ name, low: -2, high: 2, points: GOLDEN.length }));

describe.each(BUILDS)("%s", (build) => {
  it("has the golden labels, tile by tile", async () => {
    const core = await load(build);
    const map = GOLDEN.map(() => Array<string>(GOLDEN.length).fill("?"));
    for (const tile of tiles(AXES, 8, 16)) {
      const basins = core.basins(MAGNETS, tile);
      expect(basins.report.attractors.length).toBe(3);
      basins.labels.forEach((label, member) => {
        const [i = 0, j = 0] = place(tile, member);
        (map[j] ?? [])[i] = label < 0 ? "-" : String(label);
      });
      basins.free();
    }
    expect(map.map((row) => row.join(""))).toEqual(GOLDEN);
  }, 60_000);

  it("labels more starts, and not all rightly, in a draft", async () => {
    const core = await load(build);
    const row = GOLDEN.findIndex((labels) => labels.includes("-"));
    const line = AXES.map((axis, k) => ({
      ...axis,
      part: { first: k ? row : 0, stride: 1, points: k ? 1 : GOLDEN.length },
    }));
    const draft = core.basins(MAGNETS, line, { draft: true });
    expect(draft.labels.every((label) => label >= 0)).toBe(true);
    draft.free();
  });
});

it("tells how far it is, can be ended, and says what it cannot do", async () => {
  const core = await load("precess");
  const done: number[] = [];
  const ended = core.basins(MAGNETS, AXES, {
    progress: (members) => {
      done.push(members);
      return members < 50;
    },
  });
  expect(done.every((members, k) => members >= (done[k - 1] ?? 0) && members <= GOLDEN.length ** 2)).toBe(
    true,
  );
  expect(ended.labels.at(-1)).toBe(-1);
  expect(ended.labels.some((label) => label >= 0)).toBe(true);
  const free = MAGNETS.replace("r = 0.2", "r = 0");
  expect(() => core.basins(free, AXES)).toThrow(CoreError);
  expect(() => core.basins(free, AXES)).toThrow("friction");
  expect(() => core.basins(MAGNETS, [])).toThrow("no axes");
});
