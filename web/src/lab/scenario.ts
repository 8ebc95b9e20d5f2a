// A scenario as the lab edits it: every value is the text that a person typed, and the core reads it.

import type { Catalogue, Method, System } from "../core";

export interface Scenario {
  readonly title: string;
  /** Its name in legends; mostly empty. */
  readonly label: string;
  readonly system: string;
  readonly parameters: Readonly<Record<string, string>>;
  readonly start: Readonly<Record<string, string>>;
  /** Empty for the card's own. */
  readonly method: string;
  /** `dt`, `rtol`, `atol`, `until`, `every` and the method's options. */
  readonly run: Readonly<Record<string, string>>;
  /** Watched crossings and panels (`[[event]]`, `[[figure]]`), word for word. */
  readonly rest: string;
}

/** The parts in which a value may stand. */
export type Part = "parameters" | "start" | "run";

const NUMBER = /^[+-]?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/;

/** A text between quotes, as TOML has it. */
function quoted(text: string): string {
  return JSON.stringify(text).replace(/[\u007f]/g, "\\u007f");
}

function value(text: string): string {
  return NUMBER.test(text) ? text : quoted(text);
}

function table(name: string, values: Readonly<Record<string, string>>): string[] {
  const lines = Object.entries(values).map(([key, text]) => `${key} = ${value(text)}`);
  return lines.length ? ["", `[${name}]`, ...lines] : [];
}

/** The scenario file: a line for every value. */
export function toml(scenario: Scenario): string {
  const { title, label, system, parameters, start, method, run, rest } = scenario;
  return [
    "precess = 1",
    ...(title ? [`title = ${quoted(title)}`] : []),
    ...(label ? [`label = ${quoted(label)}`] : []),
    "",
    "[system]",
    `id = ${quoted(system)}`,
    ...table("system.parameters", parameters),
    ...table("start", start),
    "",
    "[run]",
    ...(method ? [`method = ${quoted(method)}`] : []),
    ...Object.entries(run).map(([key, text]) => `${key} = ${value(text)}`),
    ...(rest ? ["", rest.trim()] : []),
    "",
  ].join("\n");
}

/** A system with the card's defaults, sampled finely enough to be watched. */
export function fresh({ id, defaults }: System): Scenario {
  const every = round125(Math.abs(defaults.until) / 4000);
  return {
    title: "",
    label: "",
    system: id,
    parameters: {},
    start: {},
    method: "",
    run: { every },
    rest: "",
  };
}

/** The largest of 1, 2, 5, 10, ... that is not above a number. */
export function round125(x: number): string {
  const power = Math.floor(Math.log10(x));
  const digit = [5, 2, 1].find((d) => d * 10 ** power <= x * (1 + 1e-12)) ?? 1;
  return String(Number(`${digit}e${power}`));
}

/** With one value set, or taken back to the card's default where the text is empty. */
export function withValue(scenario: Scenario, part: Part, name: string, text: string): Scenario {
  const others = Object.entries(scenario[part]).filter(([key]) => key !== name);
  const values = { ...scenario[part], [name]: text };
  return { ...scenario, [part]: text.trim() === "" ? Object.fromEntries(others) : values };
}

/** Under another method: of the settings only those that it understands are kept. */
export function by(scenario: Scenario, method: Method): Scenario {
  const own = ["until", "every", ...settings(method)];
  const kept = Object.entries(scenario.run).filter(([name]) => own.includes(name));
  return { ...scenario, method: method.id, run: Object.fromEntries(kept) };
}

/** The names of a method's settings. */
export function settings(method: Method): string[] {
  return [...(method.adaptive ? ["rtol", "atol"] : ["dt"]), ...method.options.map(({ name }) => name)];
}

/** The scenario that starts where another one is at some moment. */
export function fork(scenario: Scenario, state: Readonly<Record<string, number>>): Scenario {
  const start = Object.fromEntries(Object.entries(state).map(([name, x]) => [name, exact(x)]));
  return { ...scenario, start };
}

/** The shortest text that reads back to the same number, as TOML writes it. */
export function exact(x: number): string {
  return Object.is(x, -0) ? "-0.0" : String(x).replace("e+", "e");
}

export function systemOf(catalogue: Catalogue, { system }: Scenario): System | undefined {
  return catalogue.systems.find(({ id }) => id === system);
}

/** The method that a scenario runs by, its own or the card's. */
export function methodOf(catalogue: Catalogue, scenario: Scenario): Method | undefined {
  const id = scenario.method || systemOf(catalogue, scenario)?.defaults.method;
  return catalogue.methods.find((method) => method.id === id);
}

/** Where a sentence of the core belongs: the field it names, or the one whose line it names. */
export function blame(sentence: string, text: string): { field: string; why: string } {
  const lined = /^line (\d+): (.*)$/s.exec(sentence);
  const why = lined?.[2] ?? sentence;
  const named = /^(\w+): (.*)$/s.exec(why);
  if (named?.[1] !== undefined && named[2] !== undefined) return { field: named[1], why: named[2] };
  const line = lined ? text.split("\n")[Number(lined[1]) - 1] : undefined;
  const owner = /^(\w+) = /.exec(line ?? "")?.[1];
  // The settings of a run are named within the sentence: "dt must be above zero".
  return { field: owner ?? /^'?(\w+)'? (?:must|is|lies)/.exec(why)?.[1] ?? "", why };
}
