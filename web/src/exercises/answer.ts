// What an exercise asks of a run, and how the simulation answers: nothing here is known beforehand.

import type { Look } from "../lab/result";
import { toml, withValue, exact, type Part, type Scenario } from "../lab/scenario";

/** `event` names a watched crossing of the exercise's scenario. */
export type Asked =
  /** The value of a quantity when the run ends. */
  | { kind: "end"; of: string }
  /** The largest value of a quantity, from a time on. */
  | { kind: "largest"; of: string; after?: number }
  /** The time from the last crossing but one to the last. */
  | { kind: "period"; event: string }
  /** The value of a coordinate or velocity at the first crossing. */
  | { kind: "crossing"; event: string; of: string }
  /** The start or parameter between two values on whose sides the crossing comes and does not. */
  | { kind: "threshold"; event: string; part: Part; of: string; between: [number, number] };

export type Compute = (text: string) => Promise<Look>;

/** The simulation's answer. */
export async function answer(scenario: Scenario, asked: Asked, compute: Compute): Promise<number> {
  if (asked.kind === "threshold") return threshold(scenario, asked, compute);
  const look = await compute(toml(scenario));
  const last = look.times.length - 1;
  if (asked.kind === "end") return look.at(asked.of, last);
  if (asked.kind === "largest") {
    const values = look.column(asked.of).filter((_, k) => (look.times[k] ?? 0) >= (asked.after ?? -Infinity));
    return Math.max(...values);
  }
  const crossings = look.result.events.filter(({ name }) => name === asked.event);
  if (asked.kind === "crossing") return crossings[0]?.state[look.state.indexOf(asked.of)] ?? NaN;
  return (crossings.at(-1)?.t ?? NaN) - (crossings.at(-2)?.t ?? NaN);
}

/** By halving: six digits are more than anybody types. */
async function threshold(
  scenario: Scenario,
  { event, part, of, between }: Extract<Asked, { kind: "threshold" }>,
  compute: Compute,
): Promise<number> {
  const comes = async (value: number) => {
    const look = await compute(toml(withValue(scenario, part, of, exact(value))));
    return look.result.events.some(({ name }) => name === event);
  };
  let [low, high] = between;
  const below = await comes(low);
  if (below === (await comes(high))) return NaN;
  while (high - low > 1e-6 * high) {
    const middle = (low + high) / 2;
    if ((await comes(middle)) === below) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** A typed answer as a number: the core reads it, so fractions, roots and degrees may stand in it. */
export async function typed(text: string, compute: Compute): Promise<number> {
  const scenario = { title: "", label: "", parameters: {}, method: "rk4", rest: "" };
  const look = await compute(
    toml({ ...scenario, system: "driven_oscillator", start: { x: text }, run: { dt: "1", until: "1" } }),
  );
  return look.at("x", 0);
}

export type Verdict = "right" | "small" | "large";

/** Whether an answer is right to a relative tolerance. */
export function verdict(given: number, right: number, tolerance: number): Verdict {
  if (Math.abs(given - right) <= tolerance * Math.abs(right)) return "right";
  return given < right ? "small" : "large";
}
