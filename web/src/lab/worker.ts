/// <reference lib="webworker" />
// The thread that holds the core. It is told a scenario and answers with a report and columns.

import { Core, CoreError } from "../core";
import { columnsOf } from "./columns";
import type { Ask, Answer } from "./messages";

let core: Core | undefined;
let stop: Int32Array | undefined;

addEventListener("message", ({ data }: MessageEvent<Ask>) => {
  void answer(data);
});

function say(message: Answer, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}

async function answer(ask: Ask): Promise<void> {
  try {
    if (ask.kind === "open") {
      core = await Core.load(ask.module);
      stop = ask.stop;
      say({ kind: "catalogue", catalogue: core.catalogue() });
    } else if (core) {
      run(core, ask.id, ask.text);
    }
  } catch (error) {
    const broken = !(error instanceof CoreError);
    say({ kind: "refused", id: ask.kind === "run" ? ask.id : 0, broken, sentence: message(error) });
  }
}

function message(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

function run(core: Core, id: number, text: string): void {
  let last = performance.now();
  const run = core.run(text, (t) => {
    const now = performance.now();
    if (now - last > 100) {
      last = now;
      say({ kind: "progress", id, t });
    }
    return !stop || Atomics.load(stop, 0) !== id;
  });
  try {
    const numbers = columnsOf(run);
    const events = run.events();
    say({ kind: "done", id, report: run.report, hash: run.hash(), events, numbers }, [numbers.buffer]);
  } finally {
    run.free();
  }
}
