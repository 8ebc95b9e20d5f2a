// The events of a run as marks: when, at which sample, what they are called.

import { sampleAt } from "./clock";
import type { Language } from "./number";
import type { Look } from "./result";

export interface Mark {
  t: number;
  /** The first sample that has it behind it. */
  sample: number;
  /** Short, for a graph. */
  name: string;
  /** As the card tells it; its name where the scenario watches for it. */
  text: string;
}

export function marksOf({ result, times }: Look, language: Language): Mark[] {
  const { events, event_texts } = result.report;
  return result.events.map(({ name, t }) => {
    const before = sampleAt(times, t);
    const sample = times[before] === t ? before : Math.min(before + 1, times.length - 1);
    const short = name.replaceAll("_", " ");
    return { t, sample, name: short, text: event_texts[events.indexOf(name)]?.[language] ?? short };
  });
}
