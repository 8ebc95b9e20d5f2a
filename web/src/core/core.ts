import type { Catalogue } from "./catalogue";
import { instantiate } from "./exports";
import { Instance } from "./instance";
import type { Report } from "./report";
import { Run } from "./run";

/** Is told the time that a run has reached, now and then; `false` ends the run, which keeps its samples. */
export type Progress = (t: number) => boolean | undefined;

/** The core of Precess in this thread. A call blocks until it is done: a page keeps it in a worker. */
export class Core {
  readonly #instance: Instance;
  readonly #watch: Watch;
  #catalogue: Catalogue | undefined;

  private constructor(instance: Instance, watch: Watch) {
    this.#instance = instance;
    this.#watch = watch;
  }

  /** From the bytes of the file, or from a module that has been compiled (and may be shared by workers). */
  static async load(source: BufferSource | WebAssembly.Module): Promise<Core> {
    const watch = new Watch();
    const exports = await instantiate(source, (t) => watch.look(t));
    return new Core(new Instance(exports), watch);
  }

  /** Systems with their equations, methods, scenarios. */
  catalogue(): Catalogue {
    if (!this.#catalogue) {
      this.#instance.guard((exports) => {
        exports.precess_catalogue();
      });
      this.#catalogue = JSON.parse(this.#instance.answer()) as Catalogue;
    }
    return this.#catalogue;
  }

  /** Runs a scenario (TOML). Throws a `CoreError` with a sentence where the scenario makes no sense. */
  run(scenario: string, progress?: Progress): Run {
    this.#instance.write(scenario);
    return this.#watch.during(progress, () => {
      const { value, answer } = this.#instance.ask((exports) => exports.precess_run());
      return new Run(this.#instance, value, JSON.parse(answer) as Report);
    });
  }

  /** Bytes in use in the core, and all that its memory has grown to (it never shrinks). */
  memory(): { used: number; size: number } {
    const { memory, precess_used } = this.#instance.exports;
    return { used: precess_used() >>> 0, size: memory.buffer.byteLength };
  }
}

/** Whoever watches the run in progress. What he throws must not fly through the core: it waits until the run is over. */
class Watch {
  #progress: Progress | undefined;
  #thrown: { error: unknown } | undefined;

  look(t: number): number {
    try {
      return this.#progress?.(t) === false ? 1 : 0;
    } catch (error) {
      this.#thrown = { error };
      return 1;
    }
  }

  during(progress: Progress | undefined, call: () => Run): Run {
    const outer = this.#progress;
    this.#progress = progress;
    try {
      const run = call();
      if (this.#thrown) {
        run.free();
        throw this.#thrown.error;
      }
      return run;
    } finally {
      this.#progress = outer;
      this.#thrown = undefined;
    }
  }
}
