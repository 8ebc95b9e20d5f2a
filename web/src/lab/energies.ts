// The energies among a run's quantities, as the card names them.

import type { System } from "../core";
import type { Look } from "./result";

/** Their names, the total last; none where there is but one. */
export function energiesOf(system: System | undefined, look: Look): string[] {
  const names = (system?.observables ?? [])
    .filter(({ name, text }) => look.has(name) && /\benergy\b/.test(text.en))
    .map(({ name }) => name)
    .toSorted((a, b) => Number(a === "energy") - Number(b === "energy"));
  return names.length > 1 ? names : [];
}

/** From the lowest to the highest of them in the whole run, zero included. */
export function rangeOf(look: Look, names: readonly string[]): [number, number] {
  let [low, high] = [0, 0];
  for (const name of names) {
    for (const x of look.column(name)) {
      if (x < low) low = x;
      if (x > high && x < Infinity) high = x;
    }
  }
  return [low, high];
}
