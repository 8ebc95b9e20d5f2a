// Runs scenarios one after the other in a worker. A run that takes long gives way to a newer one.

import type { Catalogue } from "../core";
// The first page needs one system, and no run needs lanes.
import firstUrl from "../../wasm/precess-first.wasm?url";
import url from "../../wasm/precess.wasm?url";
import type { Answer, Ask } from "./messages";

export type Done = Extract<Answer, { kind: "done" }>;

/** The sentence with which the core refuses a scenario. */
export class Refusal extends Error {
  override readonly name = "Refusal";
}
/** A run that was ended from outside. */
export class Cancelled extends Error {
  override readonly name = "Cancelled";
}

/** How long a run that is told to end may take to do so, in milliseconds. */
const PATIENCE = 1000;

interface Job {
  id: number;
  text: string;
  progress: (t: number) => void;
  resolve: (done: Done) => void;
  reject: (error: Error) => void;
}

export class Runner {
  #module: WebAssembly.Module;
  #worker: Worker;
  readonly #stop = globalThis.crossOriginIsolated
    ? new Int32Array(new SharedArrayBuffer(Int32Array.BYTES_PER_ELEMENT))
    : undefined;
  #now: Job | undefined;
  #queue: Job[] = [];
  #last = 0;
  private constructor(module: WebAssembly.Module) {
    this.#module = module;
    this.#worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  }

  /** With the small core of the first page. */
  static async open(): Promise<Runner> {
    const runner = new Runner(await moduleAt(firstUrl));
    await runner.#start();
    return runner;
  }

  /** Takes the core that has everything, and says what that is. */
  async grow(): Promise<Catalogue> {
    this.#module = await moduleAt(url);
    // A run in progress is one that waits, too: whoever asks for more than the first page waits for this.
    if (this.#now) this.#queue.unshift(this.#now);
    this.#now = undefined;
    const catalogue = await this.#restart();
    this.#next();
    return catalogue;
  }

  #ask(ask: Ask): void {
    this.#worker.postMessage(ask);
  }

  #start(): Promise<Catalogue> {
    const worker = this.#worker;
    return new Promise((resolve, reject) => {
      worker.onerror = (event) => {
        reject(new Error(event.message));
        this.#fail(new Refusal(event.message));
      };
      worker.onmessage = ({ data }: MessageEvent<Answer>) => {
        if (data.kind === "catalogue") resolve(data.catalogue);
        else if (data.kind === "refused" && data.id === 0) reject(new Error(data.sentence));
        else this.#hear(data);
      };
      this.#ask({ kind: "open", module: this.#module, stop: this.#stop });
    });
  }

  #hear(answer: Answer): void {
    const job = this.#now;
    if (answer.kind === "catalogue" || answer.id !== job?.id) return;
    if (answer.kind === "progress") {
      job.progress(answer.t);
      return;
    }
    this.#now = undefined;
    if (answer.kind === "done") job.resolve(answer);
    else job.reject(new Refusal(answer.sentence));
    if (answer.kind === "refused" && answer.broken) this.#restart().catch(() => undefined);
    this.#next();
  }

  #fail(error: Error): void {
    this.#now?.reject(error);
    this.#now = undefined;
    this.#restart().catch(() => undefined);
    this.#next();
  }

  #restart(): Promise<Catalogue> {
    this.#worker.terminate();
    this.#worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    return this.#start();
  }

  #next(): void {
    if (this.#now) return;
    this.#now = this.#queue.shift();
    if (this.#now) this.#ask({ kind: "run", id: this.#now.id, text: this.#now.text });
  }

  /** Runs a scenario after those that wait. */
  run(text: string, progress: (t: number) => void = () => undefined): Promise<Done> {
    return new Promise((resolve, reject) => {
      this.#queue.push({ id: ++this.#last, text, progress, resolve, reject });
      this.#next();
    });
  }

  /** Ends what runs, which keeps its samples where the core can be told in time, and forgets what waits. */
  cancel(): void {
    for (const job of this.#queue.splice(0)) job.reject(new Cancelled());
    const job = this.#now;
    if (!job) return;
    if (!this.#stop) {
      this.#fail(new Cancelled());
      return;
    }
    Atomics.store(this.#stop, 0, job.id);
    setTimeout(() => {
      if (this.#now === job) this.#fail(new Cancelled());
    }, PATIENCE);
  }

  /** Whether a run is under way. */
  get busy(): boolean {
    return this.#now !== undefined;
  }
}

/** The core with everything in it, of which the browser keeps the file. */
export const wholeCore = () => moduleAt(url);

async function moduleAt(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
