// How far the run that is shown can be trusted, worked out by a thread of its own, which is ended when nobody asks any more.

import { wholeCore } from "./runner";
import type { TrustAnswer, TrustAsk } from "./trustworker";

/** The error that is borne, as a share. */
export const WITHIN = 1e-3;

/** Asks; the answer ends the work, and so does the function that is returned. */
export function shadow(text: string, told: (answer: TrustAnswer) => void): () => void {
  const worker = new Worker(new URL("./trustworker.ts", import.meta.url), { type: "module" });
  const end = () => {
    worker.terminate();
  };
  const hear = (answer: TrustAnswer) => {
    if (answer.kind !== "progress") end();
    told(answer);
  };
  worker.onmessage = ({ data }: MessageEvent<TrustAnswer>) => {
    hear(data);
  };
  worker.onerror = ({ message }) => {
    hear({ kind: "refused", sentence: message });
  };
  wholeCore().then(
    (module) => {
      const ask: TrustAsk = { module, text, within: WITHIN };
      worker.postMessage(ask);
    },
    (error: unknown) => {
      hear({ kind: "refused", sentence: String(error) });
    },
  );
  return end;
}
