// The parts of the lab that need no page: scenario texts, links, the time bar's arithmetic, fields, exports.

import { deflateSync, strToU8 } from "fflate";
import { describe, expect, it } from "vitest";
import { ticks } from "../src/draw/ticks";
import { advance, nearest, sampleAt } from "../src/lab/clock";
import { command } from "../src/lab/export";
import { decode, encode } from "../src/lab/link";
import { fromField, inField, shown, unitText } from "../src/lab/number";
import { blame, by, exact, fork, fresh, round125, toml, withValue } from "../src/lab/scenario";
import { scenarioOf, Unread } from "../src/lab/toml";
import { BUILDS, load } from "./builds";

const [, BUILD] = BUILDS;

describe("scenario texts", () => {
  it("come back from the reader as they were, and run to the same bits as the file", async () => {
    const core = await load(BUILD);
    const texts = core.catalogue().scenarios.map(({ text }) => text);
    texts.push(`${texts[0] ?? ""}\n[[event]]\nname = "a"\nwhen = "theta = 1"\n\n[[figure]]\ny = ["theta"]\n`);
    expect(texts.length).toBeGreaterThan(3);
    for (const text of texts) {
      const scenario = scenarioOf(text);
      expect(scenarioOf(toml(scenario))).toEqual(scenario);
      const [file, again] = [core.run(text), core.run(toml(scenario))];
      expect(again.hash()).toBe(file.hash());
      expect(again.report.scenario).toBe(file.report.scenario);
      expect(again.events()).toEqual(file.events());
      // What the core spells out is read too, and runs to the same bits.
      const whole = core.run(toml(scenarioOf(file.report.scenario)));
      expect(whole.hash()).toBe(file.hash());
      for (const run of [file, again, whole]) run.free();
    }
  });

  it("pass on what a person types", async () => {
    const core = await load(BUILD);
    const [system] = core.catalogue().systems.filter(({ id }) => id === "pendulum");
    if (!system) throw new Error("no pendulum");
    const starts = ["30 deg", "pi/6", "0.5235987755982988", "0,5235987755982988"].map((typed) => {
      const text = toml(withValue(fresh(system), "start", "theta", fromField(typed)));
      const run = core.run(text);
      const [first] = run.column("theta");
      run.free();
      return first;
    });
    expect(new Set(starts).size).toBe(1);
    expect(toml(withValue(fresh(system), "start", "theta", '"\\\n\u007f'))).toContain('"\\"\\\\\\n\\u007f"');
  });

  it("refuses what it does not know instead of guessing", () => {
    for (const text of [
      'a = """x"""',
      "a = 1979-05-27",
      "a = [1, 2",
      "a = 1 2",
      "a.b = 1\na = 2",
      "= 1",
      'a = "\\q"',
    ]) {
      expect(() => scenarioOf(text), text).toThrow(Unread);
    }
    expect(() => scenarioOf(`a = ${"[".repeat(100_000)}`)).toThrow(Unread);
  });

  it("start anew from a state, to the bit", async () => {
    const core = await load(BUILD);
    const scenario = { ...scenarioOf(core.catalogue().scenarios[0]?.text ?? ""), rest: "" };
    const run = core.run(toml(scenario));
    const names = run.report.columns.filter(({ kind }) => kind === "state").map(({ name }) => name);
    const state = Object.fromEntries(names.map((name) => [name, run.column(name)[777] ?? NaN]));
    const forked = core.run(toml(fork(scenario, state)));
    for (const name of names) expect(forked.column(name)[0], name).toBe(state[name]);
    run.free();
    forked.free();
  });

  it("keep under another method only the settings that it knows", async () => {
    const core = await load(BUILD);
    const { methods, scenarios } = core.catalogue();
    const scenario = scenarioOf(scenarios[0]?.text ?? "");
    for (const method of methods) {
      const changed = by({ ...scenario, run: { ...scenario.run, dt: "0.01", until: "0.1" } }, method);
      const picky = method.separable_only || method.closed_form_only;
      if (picky) expect(() => core.run(toml(changed))).toThrow(method.id);
      else core.run(toml(changed)).free();
    }
  });

  it("know which field a sentence of the core is about", async () => {
    const core = await load(BUILD);
    const base = {
      title: "",
      label: "",
      system: "pendulum",
      parameters: {},
      start: {},
      method: "rk4",
      run: {},
      rest: "",
    };
    const cases = [
      ["parameters", "l", "1 kg"],
      ["parameters", "l", "-1"],
      ["parameters", "l", "abc def"],
      ["start", "theta", "1 +"],
      ["run", "dt", "0"],
      ["run", "until", "2 kg"],
    ] as const;
    for (const [part, name, typed] of cases) {
      const text = toml(withValue(base, part, name, typed));
      expect.soft(() => core.run(text), text).toThrow();
      try {
        core.run(text);
      } catch (error) {
        expect.soft(blame(error instanceof Error ? error.message : "", text).field, String(error)).toBe(name);
      }
    }
  });
});

describe("links", () => {
  const TEXT = 'precess = 1\n[system]\nid = "pendulum"\n';

  it("come back as they were", () => {
    for (const text of [TEXT, `# é ∞ 𝄞\n${TEXT}`, TEXT.repeat(500)]) {
      expect(decode(`#${encode(text)}`)).toEqual({ text });
    }
    expect(encode(TEXT)).toMatch(/^1\.[\w-]+$/);
    expect(decode("")).toBeUndefined();
    expect(decode("#")).toBeUndefined();
  });

  it("that are damaged, huge or newer say so", () => {
    const good = encode(TEXT);
    const wrong = (hash: string) => {
      const decoded = decode(hash);
      return decoded && "wrong" in decoded ? decoded.wrong : "nothing";
    };
    expect(wrong("#2.abc")).toBe("newer");
    expect(wrong("#0.abc")).toBe("broken");
    expect(wrong("#about")).toBe("broken");
    expect(wrong("#1.")).toBe("broken");
    expect(wrong("#1.%%%")).toBe("broken");
    expect(wrong(`#${good.slice(0, -6)}`)).toBe("broken");
    expect(wrong(`#1.${"A".repeat(100_000)}`)).toBe("huge");
    const bomb = deflateSync(strToU8(" ".repeat(50_000_000)), { level: 9 });
    const payload = Buffer.from(bomb).toString("base64url");
    expect(payload.length).toBeLessThan(1 << 17);
    expect(wrong(`#1.${payload.slice(0, 65_000)}`)).toBe("huge");
    for (let k = 2; k < good.length; k++) {
      const decoded = decode(`#${good.slice(0, k)}!${good.slice(k + 1)}`);
      expect(decoded).toEqual({ wrong: "broken" });
    }
  });
});

describe("the time bar", () => {
  const times = Float64Array.from([0, 0.5, 1, 1.5, 2]);
  const back = times.map((t) => -t);

  it("lands on samples", () => {
    expect([-1, 0, 0.49, 0.5, 1.99, 2, 9].map((t) => sampleAt(times, t))).toEqual([0, 0, 0, 1, 3, 4, 4]);
    expect([1, 0, -0.49, -0.5, -1.99, -2, -9].map((t) => sampleAt(back, t))).toEqual([0, 0, 0, 1, 3, 4, 4]);
    expect([0.2, 0.3, 1.9].map((t) => nearest(times, t))).toEqual([0, 1, 4]);
    expect(sampleAt(new Float64Array(), 1)).toBe(0);
  });

  it("goes on, back, round, and stops at the end", () => {
    const on = { speed: 2, reverse: false, loop: false };
    expect(advance(times, 0.5, 0.25, on)).toEqual({ t: 1, ended: false });
    expect(advance(times, 0.5, 0.25, { ...on, reverse: true })).toEqual({ t: 0, ended: false });
    expect(advance(times, 1.9, 1, on)).toEqual({ t: 2, ended: true });
    expect(advance(times, 0.1, 1, { ...on, reverse: true })).toEqual({ t: 0, ended: true });
    expect(advance(times, 1.9, 1, { ...on, loop: true })).toEqual({ t: 0, ended: false });
    expect(advance(back, -0.5, 0.25, on)).toEqual({ t: -1, ended: false });
    expect(advance(back, -1.9, 1, on)).toEqual({ t: -2, ended: true });
  });
});

describe("numbers", () => {
  it("are written as the language has it", () => {
    expect([0, 1, 100, 0.5, -0.25, 1e6, 1.5e-7].map((x) => shown(x, "en"))).toEqual([
      "0",
      "1",
      "100",
      "0.5",
      "−0.25",
      "1e6",
      "1.5e−7",
    ]);
    expect([5.9e-10, 2e-20, 1e10, 2.5e100].map((x) => shown(x, "en", 2))).toEqual([
      "5.9e−10",
      "2e−20",
      "1e10",
      "2.5e100",
    ]);
    expect(shown(1.5e-7, "fr")).toBe("1,5e−7");
    expect(shown(NaN, "en")).toBe("–");
    expect(inField("0.5", "fr")).toBe("0,5");
    expect(inField("[0.5; 1]", "fr")).toBe("[0.5; 1]");
    expect([fromField(" 0,5 "), fromField("−2"), fromField("30 deg")]).toEqual(["0.5", "-2", "30 deg"]);
  });

  it("have units as people write them", () => {
    expect(["kg m^2/s", "1/s^4", "1", "", "rad"].map(unitText)).toEqual(["kg m²/s", "1/s⁴", "", "", "rad"]);
  });

  it("are kept exactly", () => {
    for (const x of [0.1, -0, 1e300, 5e-324, 123456789.123, 1e21])
      expect(Object.is(Number(exact(x)), x)).toBe(true);
    expect([0.005, 0.0007, 3, 1].map(round125)).toEqual(["0.005", "0.0005", "2", "1"]);
  });

  it("divide an axis at round places", () => {
    expect(ticks(0, 10, 5)).toEqual([0, 2, 4, 6, 8, 10]);
    expect(ticks(1, 1, 5)).toEqual([1]);
  });
});

it("the command says all that the scenario says", () => {
  const scenario = scenarioOf(
    'precess = 1\n[system]\nid = "n_body"\nparameters = { masses = [10, 1] }\n[start]\nx0 = "-1/2"\n[run]\nmethod = "newmark"\nepsilon = 0.5\ndt = 0.01\n',
  );
  expect(command(scenario)).toBe(
    "precess run n_body -p 'masses=[10; 1]' -i x0=-1/2 --method newmark --option epsilon=0.5 --dt 0.01",
  );
  expect(command({ ...scenario, start: { x0: "it's; rm" } })).toContain(`-i 'x0=it'\\''s; rm'`);
});
