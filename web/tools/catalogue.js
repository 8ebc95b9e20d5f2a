import { readFileSync } from "node:fs";

/**
 * The catalogue as the whole core tells it, for what is built before there is a page.
 * @returns {Promise<import("../src/core").Catalogue>}
 */
export async function catalogue() {
  const file = readFileSync(new URL("../wasm/precess.wasm", import.meta.url));
  const { instance } = await WebAssembly.instantiate(file, { precess: { progress: () => 0 } });
  const core = /** @type {import("../src/core/exports").CoreExports} */ (
    /** @type {unknown} */ (instance.exports)
  );
  core.precess_catalogue();
  const answer = new Uint8Array(core.memory.buffer, core.precess_answer() >>> 0, core.precess_answer_bytes());
  /** @type {unknown} */
  const parsed = JSON.parse(new TextDecoder().decode(answer));
  return /** @type {import("../src/core").Catalogue} */ (parsed);
}
