// Many starts at once: the golden bits in lanes, the order of a grid, tiles, failures, sentences.

import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { type Axis, type Core, CoreError, place, type Starts, tiles } from "../src/core";
import { BUILDS, load, scenario } from "./builds";

const LINES = readFileSync(new URL("../../golden/hashes.txt", import.meta.url), "utf8")
  .split("\n")
  .filter((line) => line !== "" && !line.startsWith("#"));

const MAGNETS = scenario("magnetic_pendulum", { method: '"rk4"', dt: 0.01, until: 2, every: 0.5 });
const X: Axis = { name: "x", low: -1, high: 1, points: 21 };
const Y: Axis = { name: "y", low: -2, high: 2, points: 13 };

describe.each(BUILDS)("%s", (build) => {
  it.each([true, false])("gives the golden bits among neighbours, with lanes: %s", async (lanes) => {
    const core = await load(build);
    const adaptive = new Set(
      core
        .catalogue()
        .methods.filter((card) => card.adaptive)
        .map(({ id }) => id),
    );
    const wrong = LINES.filter((line) => {
      const [system = "", method = "", step = "", until = "", every = "", hash = ""] = line.split(" ");
      const pace = adaptive.has(method) ? "rtol" : "dt";
      const text = scenario(system, { method: `"${method}"`, [pace]: step, until, every });
      const starts = neighbours(core, text);
      const ensemble = core.ensemble(text, starts, { keep: "samples", lanes });
      // A neighbour differs, so one lane's bits in another would be noticed.
      const same = ensemble.hash(PLACE) === hash && ensemble.hash(PLACE + 1) !== hash;
      ensemble.free();
      return !same;
    });
    expect(wrong).toEqual([]);
  });

  it("goes through a grid with the first axis fastest", async () => {
    const core = await load(build);
    const ensemble = core.ensemble(MAGNETS, [X, Y], { keep: "samples" });
    const { members, columns, failed, scenario } = ensemble.report;
    expect([members, failed]).toEqual([21 * 13, 0]);
    expect(columns.map(({ name }) => name)).toEqual(["x", "y", "x_dot", "y_dot"]);
    expect(scenario).toContain("dt = 0.01");
    expect(ensemble.times).toEqual(Float64Array.of(0, 0.5, 1, 1.5, 2));
    expect(ensemble.numbers.length).toBe(members * 5 * 4);
    const value = ({ low, high, points }: Axis, k: number) => low + (high - low) * (k / (points - 1));
    expect(ensemble.column("x", 0)).toEqual(
      Float64Array.from({ length: members }, (_, k) => value(X, k % 21)),
    );
    expect(ensemble.column("y", 0)).toEqual(
      Float64Array.from({ length: members }, (_, k) => value(Y, Math.floor(k / 21))),
    );
    // A member is the run of its start alone.
    const [x = NaN, y = NaN] = [ensemble.column("x", 0)[100], ensemble.column("y", 0)[100]];
    const alone = core.run(`${MAGNETS}\n[start]\nx = ${x}\ny = ${y}\n`);
    expect(ensemble.hash(100)).toBe(alone.hash());
    const ends = core.ensemble(MAGNETS, [X, Y]);
    expect(ends.times).toEqual(Float64Array.of(2));
    expect(ends.column("x_dot")).toEqual(ensemble.column("x_dot"));
    expect(() => ends.column("z")).toThrow("no column z");
  });

  it("gives the bits of the whole in tiles, each start once", async () => {
    const core = await load(build);
    const whole = core.ensemble(MAGNETS, [X, Y]).column("x");
    const map = new Float64Array(X.points * Y.points).fill(NaN);
    for (const tile of tiles([X, Y], 4, 5)) {
      const part = core.ensemble(MAGNETS, tile);
      part.column("x").forEach((x, member) => {
        const [i = NaN, j = NaN] = place(tile, member);
        expect(map[j * X.points + i]).toBeNaN();
        map[j * X.points + i] = x;
      });
      part.free();
    }
    expect(map).toEqual(whole);
  });

  it("takes starts one by one, and tells which failed and why", async () => {
    const core = await load(build);
    const values = [0.5, 0, 1.7e308, 1.7e308, 0, 1];
    const text = MAGNETS.replace("dt = 0.01", "dt = 0.5");
    const ensemble = core.ensemble(text, { names: ["x", "x_dot"], values }, { keep: "samples" });
    expect(ensemble.report.failed).toBe(1);
    expect(ensemble.failed()).toEqual([1]);
    expect(ensemble.failure(1)).toMatch(/the state is no longer finite after t = 0\.0 s/);
    expect(() => ensemble.failure(0)).toThrow("this member has not failed");
    expect(() => ensemble.hash(3)).toThrow("there is no such member");
    expect(ensemble.column("x", 0)).toEqual(Float64Array.of(0.5, 1.7e308, 0));
    expect(ensemble.column("x")[1]).toBeNaN();
    expect(ensemble.column("x")[2]).not.toBeNaN();
    ensemble.free();
    expect(() => ensemble.numbers).toThrow("freed");
    // Steps that differ from member to member.
    const adaptive = scenario("pendulum", { method: '"dop853"', until: 10, every: 5 });
    const swing = core.ensemble(adaptive, { names: ["theta"], values: [1, 2] }, { keep: "samples" });
    expect(swing.hash(0)).toBe(core.run(adaptive).hash());
  });

  it("tells how many members are done, and ends the work", async () => {
    const core = await load(build);
    const done: number[] = [];
    const progress = (members: number) => done.push(members) < 3;
    const ensemble = core.ensemble(MAGNETS, [X, Y], { progress });
    const last = done[2] ?? NaN;
    expect(done.length).toBe(3);
    expect(done).toEqual([...done].sort((a, b) => a - b));
    expect(ensemble.failed()).toEqual(Array.from({ length: 21 * 13 - last }, (_, k) => last + k));
    expect(ensemble.failure(last)).toBe("interrupted at t = 0.0 s");
    expect(ensemble.column("x")[last]).toBeNaN();
    expect(ensemble.column("x")[last - 1]).not.toBeNaN();
    const throws = () => {
      throw new Error("enough");
    };
    expect(() => core.ensemble(MAGNETS, [X, Y], { progress: throws })).toThrow("enough");
  });

  it("answers what makes no sense with a sentence", async () => {
    const core = await load(build);
    const sentence = (starts: Starts | Axis[], text = MAGNETS, keep: "last" | "samples" = "last") => {
      const refused = () => core.ensemble(text, starts, { keep });
      expect(refused).toThrow(CoreError);
      try {
        refused();
      } catch (error) {
        return (error as Error).message;
      }
      return "";
    };
    expect(sentence([X, { ...Y, name: "z" }])).toContain("no start of magnetic_pendulum 'z': known are x, y");
    expect(sentence([X, { ...Y, name: "y\nz" }])).toContain("no start of magnetic_pendulum");
    expect(sentence([X, { ...Y, points: 0 }])).toBe("the grid along y has no points");
    expect(sentence([X, { ...Y, high: Infinity }])).toBe("y cannot start at inf");
    expect(sentence([X, { ...Y, part: { first: 10, stride: 1, points: 4 } }])).toContain("from number 10 on");
    expect(sentence([X, { ...Y, part: { first: -1, stride: 1, points: 4 } }])).toContain("whole numbers");
    expect(sentence([X, { ...Y, points: 1e9 }])).toContain("do not fit into the memory of this page");
    expect(sentence({ names: ["x", "y"], values: [1, 2, 3] })).toBe("3 numbers are no values of x, y");
    expect(sentence({ names: [], values: [] })).toContain("0 numbers");
    expect(sentence([])).toContain("0 numbers");
    expect(sentence([X], MAGNETS.replace("rk4", "rk5"))).toContain("did you mean 'rk4'?");
    const watched = `${MAGNETS}[[event]]\nname = "there"\nwhen = "x = 0"\n`;
    expect(sentence([X], watched)).toContain("watches no events");
    const long = MAGNETS.replace("every = 0.5", "every = 1e-6");
    expect(sentence([X, Y], long, "samples")).toContain("make 'every' longer, or keep the ends alone");
    expect(core.ensemble(MAGNETS, [X]).report.members).toBe(21);
  });

  it("needs no more memory after a hundred tiles than after one", async () => {
    const core = await load(build);
    const once = () => {
      core.ensemble(MAGNETS, [X, Y]).free();
      expect(() => core.ensemble(MAGNETS, [X, { ...Y, points: 0 }])).toThrow(CoreError);
    };
    once();
    const before = core.memory();
    for (let n = 0; n < 100; n++) once();
    expect(core.memory()).toEqual(before);
  });
});

it("cuts any grid into tiles that hold each start once, coarse ones first", () => {
  for (const sizes of [[1], [7], [8, 9], [33, 5], [3, 4, 5]]) {
    const axes = sizes.map((points, k): Axis => ({ name: `q${k}`, low: 0, high: 1, points }));
    const all = [...tiles(axes, 8, 3)];
    const places = all.flatMap((tile) => {
      const members = tile.reduce((product, { part }) => product * (part?.points ?? NaN), 1);
      return Array.from({ length: members }, (_, member) => place(tile, member));
    });
    expect(new Set(places.map(String)).size).toBe(places.length);
    expect(places.length).toBe(sizes.reduce((a, b) => a * b));
    expect(places.every((at) => at.every((k, axis) => k < (sizes[axis] ?? NaN)))).toBe(true);
    const strides = all.map((tile) => tile[0]?.part?.stride ?? NaN);
    expect(strides).toEqual([...strides].sort((a, b) => b - a));
  }
});

const PLACE = 7;

/** A scenario's own start among others that differ a little, more than a block holds of the narrower lanes. */
function neighbours(core: Core, text: string): Starts {
  const alone = core.run(text, () => false);
  const names = alone.report.columns.filter(({ kind }) => kind === "state").map(({ name }) => name);
  const start = names.map((name) => alone.column(name)[0] ?? NaN);
  alone.free();
  // A driven system may start from rest at zero, where a factor would change nothing.
  const size = start.every((x) => x === 0) ? () => 1 : Math.abs;
  const share = (member: number) => (member === PLACE ? 0 : 1e-3 * (member - 9.5));
  const moved = (x: number, member: number) => x + size(x) * share(member);
  const values = Array.from({ length: 19 }, (_, member) => start.map((x) => moved(x, member))).flat();
  return { names, values };
}
