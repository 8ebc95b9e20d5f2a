// The catalogue has the shape that src/core/catalogue.ts gives it; menus and forms are built from it.

import { describe, expect, it } from "vitest";
import { BUILDS, load } from "./builds";

/** What a value must look like: a primitive's type, a list of one shape, an object, or any of several. */
type Shape = "string" | "number" | "boolean" | "null" | [Shape] | { [key: string]: Shape } | Set<Shape>;

/** The first place where a value has another shape; empty where it has it. No key may be missing or too many. */
function differs(value: unknown, shape: Shape, at = ""): string {
  if (shape instanceof Set) {
    const all = [...shape].map((one) => differs(value, one, at));
    return all.includes("") ? "" : (all.at(-1) ?? "");
  }
  if (typeof shape === "string") {
    return (value === null ? "null" : typeof value) === shape ? "" : `${at} is no ${shape}`;
  }
  if (Array.isArray(shape)) {
    if (!Array.isArray(value)) return `${at} is no list`;
    return value.map((item, k) => differs(item, shape[0], `${at}[${k}]`)).find(Boolean) ?? "";
  }
  if (typeof value !== "object" || value === null) return `${at} is no object`;
  const keys = Object.keys(value).sort().join();
  if (keys !== Object.keys(shape).sort().join()) return `${at} has the keys ${keys}`;
  const entries = Object.entries(value);
  return (
    entries.map(([key, item]) => differs(item, shape[key] ?? "null", `${at}.${key}`)).find(Boolean) ?? ""
  );
}

const any = (...shapes: Shape[]) => new Set(shapes);
const text = { en: "string", fr: "string" } as const;
const quantity = { name: "string", symbol: "string", unit: "string", text } as const;

const SYSTEM: Shape = {
  id: "string",
  family: "string",
  title: text,
  about: text,
  source: "string",
  coordinates: [
    any(
      { ...quantity, order: "number", start: "number" },
      { ...quantity, order: "number", start: "number", start_dot: "number" },
    ),
  ],
  state: ["string"],
  parameters: [
    any(
      {
        ...quantity,
        default: "number",
        low: any("number", "null"),
        high: any("number", "null"),
        open: "boolean",
      },
      { ...quantity, default: ["number"] },
      { ...quantity, fields: ["string"], default: [["number"]] },
      { ...quantity, default: "string", choices: ["string"] },
    ),
  ],
  observables: [any({ ...quantity, kind: "string" }, { ...quantity, kind: "string", when_zero: ["string"] })],
  starts: [quantity],
  events: [{ name: "string", text }],
  views: [{ pairs: [["string"]], equal_scales: "boolean" }],
  takes_body: "boolean",
  equations: { definitions: [["string"]], equations: [["string"]] },
  defaults: { method: "string", until: "number", dt: "number" },
};

const METHOD: Shape = {
  id: "string",
  title: text,
  about: text,
  order: "number",
  adaptive: "boolean",
  separable_only: "boolean",
  closed_form_only: "boolean",
  symplectic: "boolean",
  reversible: "boolean",
  source: "string",
  options: [{ name: "string", default: "number", low: "number", high: "number", text }],
};

const CATALOGUE: Shape = {
  systems: [SYSTEM],
  methods: [METHOD],
  scenarios: [{ file: "string", title: "string", title_fr: "string", note: text, text: "string" }],
};

describe.each(BUILDS)("%s", (build) => {
  it("has the shape that it is typed with", async () => {
    const core = await load(build);
    const catalogue = core.catalogue();
    expect(differs(catalogue, CATALOGUE)).toBe("");
    expect(core.catalogue()).toBe(catalogue);
    // Another shape is noticed, however deep it lies.
    const damaged = structuredClone(catalogue);
    Object.assign(damaged.systems.at(-1)?.parameters[0] ?? {}, { unit: 1 });
    expect(differs(damaged, CATALOGUE)).toMatch(/^\.systems\[\d+\]\.parameters\[0\]/);
  });

  it("names what the runs know", async () => {
    const core = await load(build);
    const { systems, methods } = core.catalogue();
    expect(systems.length).toBeGreaterThanOrEqual(10);
    for (const { id, state, observables, coordinates, equations, defaults } of systems) {
      const { report } = core.run(`precess = 1\n[system]\nid = "${id}"\n[run]\nuntil = 0\n`);
      const names = ["t", ...state, ...observables.map(({ name }) => name)];
      expect(report.columns.map(({ name }) => name)).toEqual(names);
      expect(report.rows).toBe(1);
      // A cluster's are those of its two galaxies and of one asteroid.
      expect(equations.equations.length).toBe(id === "cluster" ? 6 : coordinates.length);
      expect(methods.map((method) => method.id)).toContain(defaults.method);
    }
  });
});
