/// <reference lib="webworker" />
// A thread that holds one run against its shadow, and is then done with.

import { Core } from "../core";

export interface TrustAsk {
  module: WebAssembly.Module;
  text: string;
  within: number;
}
export type TrustAnswer =
  | { kind: "progress"; share: number }
  /** How many samples can be trusted, of how many; the error of the last that can. */
  | { kind: "done"; trusted: number; rows: number; error: number }
  | { kind: "refused"; sentence: string };

const say = (answer: TrustAnswer) => {
  postMessage(answer);
};

addEventListener("message", ({ data: { module, text, within } }: MessageEvent<TrustAsk>) => {
  const work = async () => {
    const core = await Core.load(module);
    let last = performance.now();
    const table = core.trust(text, within, (share) => {
      const now = performance.now();
      if (now - last > 100) {
        last = now;
        say({ kind: "progress", share });
      }
      return true;
    });
    const trusted = table.column("trusted").filter((one) => one === 1).length;
    say({ kind: "done", trusted, rows: table.report.rows, error: table.column("error")[trusted - 1] ?? NaN });
  };
  work().catch((error: unknown) => {
    say({ kind: "refused", sentence: error instanceof Error ? error.message : String(error) });
  });
});
