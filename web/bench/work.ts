// The work, in Node and in a page alike.

import { Core } from "../src/core";

export interface Timing {
  seconds: number;
  /** The hash of every member. */
  hashes: string[];
}

/** Does the work once. */
export type Work = () => Timing;

/** Gets ready: what loading and compiling take is not part of the work. */
export async function prepare(
  file: BufferSource,
  scenario: string,
  points: number,
  lanes: boolean,
): Promise<Work> {
  const core = await Core.load(file);
  const axes = ["x", "y"].map((name) => ({ name, low: -2, high: 2, points }));
  return () => {
    const begun = performance.now();
    const ensemble = core.ensemble(scenario, axes, { lanes });
    const seconds = (performance.now() - begun) / 1000;
    const hashes = Array.from({ length: ensemble.report.members }, (_, k) => ensemble.hash(k));
    ensemble.free();
    return { seconds, hashes };
  };
}

/** What a page does: the work whenever the server asks for it. */
export async function serve(points: number): Promise<void> {
  const [file, scenario] = await Promise.all([fetch("/core.wasm"), fetch("/scenario")]);
  const bytes = await file.arrayBuffer();
  const text = await scenario.text();
  const works = new Map<string, Work>();
  for (;;) {
    const wanted = await (await fetch("/next")).text();
    const work = works.get(wanted) ?? (await prepare(bytes, text, points, wanted === "lanes"));
    works.set(wanted, work);
    await fetch("/done", { method: "POST", body: JSON.stringify(work()) });
  }
}
