import { CoreBroken, CoreError } from "./error";
import type { CoreExports } from "./exports";

/** One instance of the module: texts and numbers in, answers out. */
export class Instance {
  readonly #exports: CoreExports;
  #broken: CoreBroken | undefined;

  constructor(exports: CoreExports) {
    this.#exports = exports;
  }

  get exports(): CoreExports {
    // After a trap the core's own memory is in an unknown state.
    if (this.#broken) throw this.#broken;
    return this.#exports;
  }

  /** Calls a function that gives 0 where it refuses; the answer is then the sentence. */
  ask(call: (exports: CoreExports) => number): { value: number; answer: string } {
    const value = this.guard(call);
    const answer = this.answer();
    if (value === 0) throw new CoreError(answer);
    return { value, answer };
  }

  /** Calls, and turns a trap into an error that stays. */
  guard<T>(call: (exports: CoreExports) => T): T {
    const exports = this.exports;
    try {
      return call(exports);
    } catch (cause) {
      this.#broken = new CoreBroken("the core has stopped working", { cause });
      throw this.#broken;
    }
  }

  /** Puts texts and numbers where the next call takes them, in order. */
  write(...inputs: (string | Float64Array)[]): void {
    for (const input of inputs) {
      const bytes =
        typeof input === "string"
          ? new TextEncoder().encode(input)
          : new Uint8Array(input.buffer, input.byteOffset, input.byteLength);
      const place = this.guard((exports) => exports.precess_input(bytes.length));
      if (place === 0) throw new CoreError("this does not fit into the memory");
      // The buffer is asked for after the call: it may have moved.
      new Uint8Array(this.exports.memory.buffer, place >>> 0, bytes.length).set(bytes);
    }
  }

  /** The last answer. */
  answer(): string {
    const { memory, precess_answer, precess_answer_bytes } = this.exports;
    return new TextDecoder().decode(
      new Uint8Array(memory.buffer, precess_answer() >>> 0, precess_answer_bytes()),
    );
  }

  /** Numbers in place; a pointer beyond 2 GiB comes out of the module as a negative number. */
  view(place: number, length: number): Float64Array {
    return new Float64Array(this.exports.memory.buffer, place >>> 0, length);
  }
}
