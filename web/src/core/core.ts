import { Basins } from "./basins";
import type { Catalogue } from "./catalogue";
import { Ensemble } from "./ensemble";
import { instantiate } from "./exports";
import { Instance } from "./instance";
import type { BasinsReport, EnsembleReport, Report, TableReport } from "./report";
import { Run } from "./run";
import { Table } from "./table";
import type { Axis } from "./tiles";

/**
 * Is told now and then how far the work has come: the time of a run, the members of an ensemble that are done, the share of
 * an analysis; `false` ends the work, which keeps what it has.
 */
export type Progress = (done: number) => boolean | undefined;

/** Starts one by one: names of initial values, and their values start by start. */
export interface Starts {
  names: string[];
  values: ArrayLike<number>;
}

export interface EnsembleOptions {
  /** What is kept of each member: the state at the end, or at every sample. */
  keep?: "last" | "samples";
  /** `false` computes one number at a time, not a register of them: slower, the same bits. */
  lanes?: boolean;
  /** Told the number of members that are done; those that are not when it says `false` have failed. */
  progress?: Progress;
}

export interface BasinsOptions extends Pick<EnsembleOptions, "lanes" | "progress"> {
  draft?: boolean;
}

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
    const exports = await instantiate(source, (done) => watch.look(done));
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

  /**
   * Runs a scenario (TOML) from many starts: a list of them, or a grid, of which the first axis runs fastest. A grid is
   * better asked for in `tiles`: the work is done before the call returns.
   */
  ensemble(
    scenario: string,
    starts: Starts | readonly Axis[],
    { keep = "last", lanes = true, progress }: EnsembleOptions = {},
  ): Ensemble {
    const grid = !("names" in starts);
    const names = grid ? starts.map(({ name }) => name) : starts.names;
    const numbers = Float64Array.from(grid ? starts.flatMap(numbersOf) : starts.values);
    this.#instance.write(scenario, linesOf(names), numbers);
    return this.#watch.during(progress, () => {
      const { value, answer } = this.#instance.ask((exports) =>
        exports.precess_ensemble(Number(grid), Number(keep === "samples"), Number(!lanes)),
      );
      return new Ensemble(this.#instance, value, JSON.parse(answer) as EnsembleReport);
    });
  }

  /**
   * Where the starts of a grid end, only what is proved: better asked for in `tiles`, each of which has the labels of the
   * whole grid. A `draft` follows each start once, within a loose tolerance: many labels are right. A start that work was
   * ended before is undecided.
   */
  basins(
    scenario: string,
    axes: readonly Axis[],
    { draft = false, lanes = true, progress }: BasinsOptions = {},
  ): Basins {
    this.#instance.write(
      scenario,
      linesOf(axes.map(({ name }) => name)),
      Float64Array.from(axes.flatMap(numbersOf)),
    );
    return this.#watch.during(progress, () => {
      const { value, answer } = this.#instance.ask((exports) =>
        exports.precess_basins(Number(draft), Number(!lanes)),
      );
      return new Basins(this.#instance, value, JSON.parse(answer) as BasinsReport);
    });
  }

  /**
   * How far the run of a scenario can be trusted, where a relative error `within` is borne: a table with the columns `t`,
   * `error` and `trusted`, which is one up to the horizon and zero beyond. Work that is ended gives nothing.
   */
  trust(scenario: string, within: number, progress?: Progress): Table {
    this.#instance.write(scenario);
    return this.#watch.during(progress, () => {
      const { value, answer } = this.#instance.ask((exports) => exports.precess_trust(within));
      return new Table(this.#instance, value, JSON.parse(answer) as TableReport);
    });
  }

  /** Bytes in use in the core, and all that its memory has grown to (it never shrinks). */
  memory(): { used: number; size: number } {
    const { memory, precess_used } = this.#instance.exports;
    return { used: precess_used() >>> 0, size: memory.buffer.byteLength };
  }
}

/** Names, one a line: a line break within a name would make two of it. */
const linesOf = (names: readonly string[]) => names.map((name) => name.replace(/[\r\n]/g, " ")).join("\n");

/** An axis as the core reads it. */
function numbersOf({ low, high, points, part = { first: 0, stride: 1, points } }: Axis): number[] {
  return [low, high, points, part.first, part.stride, part.points];
}

/** Whoever watches the work in progress. What he throws must not fly through the core: it waits until that is over. */
class Watch {
  #progress: Progress | undefined;
  #thrown: { error: unknown } | undefined;

  look(done: number): number {
    try {
      return this.#progress?.(done) === false ? 1 : 0;
    } catch (error) {
      this.#thrown = { error };
      return 1;
    }
  }

  during<T extends { free(): void }>(progress: Progress | undefined, call: () => T): T {
    const outer = this.#progress;
    this.#progress = progress;
    try {
      const result = call();
      if (this.#thrown) {
        result.free();
        throw this.#thrown.error;
      }
      return result;
    } finally {
      this.#progress = outer;
      this.#thrown = undefined;
    }
  }
}
