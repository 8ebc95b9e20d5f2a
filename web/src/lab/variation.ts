// What a run is compared with: the same start under another method, or with the printed equations beside the corrected.

import type { Method, Parameter, System } from "../core";
import type { Words } from "../words";
import type { Language } from "./number";
import type { Look } from "./result";
import { by, withValue, type Scenario } from "./scenario";

export interface Variation {
  id: string;
  title: (words: Words, language: Language) => string;
  /** The scenario varied; none where it would be the same, or makes no sense. */
  of: (scenario: Scenario, method: Method | undefined) => Scenario | undefined;
}

/** A run of a variation, drawn over the one at hand. */
export interface Rival {
  variation: Variation;
  look: Look | undefined;
  refusal: string;
}

export function asMethod(method: Method): Variation {
  return {
    id: `method ${method.id}`,
    title: (_, language) => method.title[language],
    of: (scenario, own) => (own?.id === method.id ? undefined : by(scenario, method)),
  };
}

/** What cards call the reading of a source word for word. */
export const PRINTED = "as_printed";

export type Choice = Extract<Parameter, { choices: string[] }>;

/** The parameters of a system that choose between what a source prints and what is right. */
export function printedIn(system: System | undefined): Choice[] {
  return (system?.parameters ?? []).filter(
    (parameter): parameter is Choice => "choices" in parameter && parameter.choices.includes(PRINTED),
  );
}

export function chosenIn({ parameters }: Scenario, { name, default: standard }: Choice): string {
  return parameters[name] ?? standard;
}

/** One of a parameter's choices. */
export function asChoice(system: string, parameter: Choice, choice: string): Variation {
  return {
    id: `${system} ${parameter.name} ${choice}`,
    title: (words) => `${parameter.name} ${choice === PRINTED ? words.asPrinted : words.corrected}`,
    of: (scenario) =>
      scenario.system === system && chosenIn(scenario, parameter) !== choice
        ? withValue(scenario, "parameters", parameter.name, choice === parameter.default ? "" : choice)
        : undefined,
  };
}
