// Runs scenarios one after the other in a worker. A run that takes long gives way to a newer one.

import type { Catalogue } from "../core";
// A run needs no lanes: the smaller core is the one that everybody loads.
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

interface Job {
  id: number;
  text: string;
  progress: (t: number) => void;
  resolve: (done: Done) => void;
  reject: (error: Error) => void;
}

export class Runner {
  readonly #module: WebAssembly.Module;
  #worker: Worker;
  #now: Job | undefined;
  #queue: Job[] = [];
  #last = 0;
  /** Everything that the core knows. */
  catalogue: Catalogue | undefined;

  private constructor(module: WebAssembly.Module) {
    this.#module = module;
    this.#worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  }

  static async open(): Promise<Runner> {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    const runner = new Runner(await WebAssembly.compile(await response.arrayBuffer()));
    runner.catalogue = await runner.#start();
    return runner;
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
      this.#ask({ kind: "open", module: this.#module });
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
    if (answer.kind === "refused" && answer.broken) this.#restart();
    this.#next();
  }

  #fail(error: Error): void {
    this.#now?.reject(error);
    this.#now = undefined;
    this.#restart();
    this.#next();
  }

  #restart(): void {
    this.#worker.terminate();
    this.#worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    this.#start().catch(() => undefined);
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

  /** Ends what runs and forgets what waits. */
  cancel(): void {
    for (const job of this.#queue.splice(0)) job.reject(new Cancelled());
    if (this.#now) this.#fail(new Cancelled());
  }

  /** Whether a run is under way. */
  get busy(): boolean {
    return this.#now !== undefined;
  }
}
