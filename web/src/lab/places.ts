// Lists whose rows are places: a magnet has fields named after the coordinates x and y.

import type { System } from "../core";
import { rowsOf, type Look } from "./result";
import { exact, withValue, type Scenario } from "./scenario";

export interface Places {
  /** The list's name. */
  parameter: string;
  fields: readonly string[];
  /** Those of the fields that are coordinates. */
  names: readonly string[];
  /** The card's own rows. */
  standard: number[][];
}

/** The first such list of a system. */
export function placesOf(system: System | undefined): Places | undefined {
  for (const parameter of system?.parameters ?? []) {
    if (!("fields" in parameter)) continue;
    const names = parameter.fields.filter((field) => system?.coordinates.some(({ name }) => name === field));
    const { name, fields, default: standard } = parameter;
    if (names.length > 1) return { parameter: name, fields, names, standard };
  }
  return undefined;
}

/** The rows as numbers: the scenario's, which the core reads where there are units or fractions in them. */
export function rowsIn(scenario: Scenario, look: Look | undefined, places: Places): number[][] {
  const text = scenario.parameters[places.parameter];
  if (text === undefined) return places.standard;
  try {
    const rows = rowsOf(text);
    if (rows.flat().every((x) => typeof x === "number")) return rows;
  } catch {
    // The last run tells.
  }
  return look?.list(places.parameter) ?? [];
}

/** With one row moved. */
export function withPlace(
  scenario: Scenario,
  { parameter, fields }: Places,
  rows: readonly (readonly number[])[],
  row: number,
  to: Readonly<Record<string, number>>,
): Scenario {
  const list = rows.map((old, k) => (k === row ? old.map((x, n) => to[fields[n] ?? ""] ?? x) : old));
  const text = list.map((one) => `[${one.map(exact).join("; ")}]`).join("; ");
  return withValue(scenario, "parameters", parameter, `[${text}]`);
}

/** Which row is nearest to each of some points, given column by column; the number of none where a point is none. */
export function nearestRow(
  { fields, names }: Places,
  rows: readonly (readonly number[])[],
  columns: readonly Float64Array[],
): Float64Array {
  const at = names.map((name) => fields.indexOf(name));
  const points = columns[0] ?? new Float64Array();
  return points.map((_, k) => {
    let [best, least] = [NaN, Infinity];
    rows.forEach((row, n) => {
      const far = at.reduce((sum, field, c) => sum + ((columns[c]?.[k] ?? NaN) - (row[field] ?? 0)) ** 2, 0);
      if (far < least) [best, least] = [n, far];
    });
    return best;
  });
}
