// A run as the views see it: columns by name, and the scenario with everything spelt out.

import type { Report, RunEvent } from "../core";
import type { Scenario } from "./scenario";
import { scenarioOf } from "./toml";

export interface Result {
  readonly scenario: Scenario;
  readonly report: Report;
  readonly hash: string;
  readonly events: RunEvent[];
  /** All columns, one after the other. */
  readonly numbers: Float64Array;
}

/** A result, looked at. */
export class Look {
  readonly result: Result;
  readonly times: Float64Array;
  /** The parameters and starts that the run really had. */
  readonly whole: Scenario;
  readonly #columns = new Map<string, Float64Array>();
  readonly #parameters = new Map<string, number | number[][]>();

  constructor(result: Result) {
    this.result = result;
    const { rows, columns, scenario } = result.report;
    columns.forEach(({ name }, k) =>
      this.#columns.set(name, result.numbers.subarray(k * rows, (k + 1) * rows)),
    );
    this.times = this.column("t");
    this.whole = scenarioOf(scenario);
    for (const [name, text] of Object.entries(this.whole.parameters)) {
      this.#parameters.set(name, text.startsWith("[") ? rowsOf(text) : Number(text));
    }
  }

  has(name: string): boolean {
    return this.#columns.has(name);
  }

  column(name: string): Float64Array {
    return this.#columns.get(name) ?? new Float64Array(this.result.report.rows);
  }

  /** A quantity at a sample. */
  at(name: string, sample: number): number {
    return this.#columns.get(name)?.[sample] ?? NaN;
  }

  unit(name: string): string {
    return this.result.report.columns.find((column) => column.name === name)?.unit ?? "";
  }

  /** A parameter that is a number. */
  parameter(name: string): number {
    const value = this.#parameters.get(name);
    return typeof value === "number" ? value : NaN;
  }

  /** A parameter that is a list, row by row. */
  list(name: string): number[][] {
    const value = this.#parameters.get(name);
    return Array.isArray(value) ? value : [];
  }

  /** The names of the state's numbers. */
  get state(): string[] {
    return this.result.report.columns.filter(({ kind }) => kind === "state").map(({ name }) => name);
  }

  stateAt(sample: number): Record<string, number> {
    return Object.fromEntries(this.state.map((name) => [name, this.at(name, sample)]));
  }

  /** The largest size of some quantities over the run. */
  reach(...names: string[]): number {
    let reach = 0;
    for (const name of names) {
      for (const x of this.column(name)) if (Math.abs(x) > reach && Number.isFinite(x)) reach = Math.abs(x);
    }
    return reach;
  }
}

/** `[10; 1]` and `[[0.5; 0; 1]; [1; 2; 3]]`, as the reader of scenarios writes lists. */
export function rowsOf(text: string): number[][] {
  const rows = JSON.parse(text.replaceAll(";", ",")) as (number | number[])[];
  return rows.map((row) => (typeof row === "number" ? [row] : row));
}
