// Times exercise 7.5 in WebAssembly (Node, Chromium) and natively with registers of the same width, in turn; the
// quickest of the rounds count. The very same bits must come out everywhere.
//
// Usage: node bench/bench.js NATIVE [ROUNDS [POINTS]], where NATIVE is the built example exercise_7_5.

// @ts-check
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync } from "node:fs";
import { rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";

/** @typedef {import("./work").Timing} Timing */
/** @typedef {typeof import("./work")} WorkModule */

const [native = "", rounds = "5", points = "32"] = process.argv.slice(2);
const here = (/** @type {string} */ name) => fileURLToPath(new URL(name, import.meta.url));
const scenario = here("exercise-7-5.toml");
const core = process.env["PRECESS_WASM"] ?? here("../wasm/precess-simd128.wasm");
const chromium = process.env["CHROMIUM"] ?? "/usr/bin/chromium";

const script = await bundle();
const { prepare } = /** @type {WorkModule} */ (
  await import(`data:text/javascript;base64,${Buffer.from(script).toString("base64")}`)
);

/** @type {Map<string, () => Timing | Promise<Timing>>} */
const places = new Map();
for (const [registers, lanes] of /** @type {const} */ ([
  ["sse2", true],
  ["scalar", false],
])) {
  const kind = lanes ? "lanes" : "plain";
  places.set(`native ${kind}`, () =>
    read(execFileSync(native, [scenario, points, registers], { maxBuffer: 1 << 28, encoding: "utf8" })),
  );
  const work = await prepare(readFileSync(core), readFileSync(scenario, "utf8"), Number(points), lanes);
  places.set(`node ${kind}`, work);
}
const browser = existsSync(chromium) ? await open() : undefined;
if (browser) {
  places.set("chromium lanes", () => browser.ask("lanes"));
  places.set("chromium plain", () => browser.ask("plain"));
} else {
  console.error(`there is no ${chromium}: the browser is left out (set CHROMIUM)`);
}

/** @type {Map<string, number[]>} */
const seconds = new Map();
let bits = "";
for (let round = 0; round < Number(rounds); round++) {
  for (const [place, work] of places) {
    const timing = await work();
    bits ||= timing.hashes.join();
    if (timing.hashes.join() !== bits) throw new Error(`${place} gives other bits`);
    seconds.set(place, [...(seconds.get(place) ?? []), timing.seconds]);
  }
}
browser?.close();

const least = (/** @type {string} */ place) => Math.min(...(seconds.get(place) ?? []));
const steps = Number(points) ** 2 * 40_000;
for (const place of seconds.keys()) {
  const ratio = least(place.replace(/^\w+/, "native")) / least(place);
  const nanoseconds = (least(place) / steps) * 1e9;
  const first = (seconds.get(place) ?? [])[0] ?? NaN;
  console.log(
    `${ratio.toFixed(2)} of native: ${place.padEnd(14)} ${nanoseconds.toFixed(2)} ns a step of a trajectory` +
      ` (first round ${((first / steps) * 1e9).toFixed(2)})`,
  );
}
console.log(`the same bits in all of them, ${rounds} rounds of ${points} x ${points} starts`);

/** A timing from JSON. */
function read(/** @type {string} */ json) {
  return /** @type {Timing} */ (JSON.parse(json));
}

/** The work and the facade as one module. */
async function bundle() {
  const made = await build({
    root: here(".."),
    configFile: false,
    logLevel: "error",
    build: { write: false, target: "esnext", lib: { entry: here("work.ts"), formats: ["es"] } },
  });
  const output = Array.isArray(made) && made[0] ? made[0].output : [];
  const chunk = output.find((piece) => piece.type === "chunk");
  if (chunk?.type !== "chunk") throw new Error("vite has built nothing");
  return chunk.code;
}

/** Opens a page that asks this server what to do next. */
async function open() {
  /** @type {((wanted: string) => void) | undefined} */
  let next;
  /** @type {((timing: Timing) => void) | undefined} */
  let done;
  /** @type {() => void} */
  let ready = () => undefined;
  const attending = new Promise(
    (resolve) =>
      (ready = () => {
        resolve(undefined);
      }),
  );
  const page = `<!doctype html><script type="module">import { serve } from "/work.js"; serve(${points})</script>`;
  /** @type {Record<string, [string, string | Buffer]>} */
  const files = {
    "/": ["text/html", page],
    "/work.js": ["text/javascript", script],
    "/core.wasm": ["application/wasm", readFileSync(core)],
    "/scenario": ["text/plain", readFileSync(scenario)],
  };
  const server = createServer((request, response) => {
    if (request.url === "/next") {
      next = (wanted) => response.end(wanted);
      ready();
    } else if (request.url === "/done") {
      /** @type {Buffer[]} */
      const chunks = [];
      request.on("data", (/** @type {Buffer} */ chunk) => chunks.push(chunk));
      request.on("end", () => {
        response.end();
        done?.(read(Buffer.concat(chunks).toString()));
      });
    } else {
      const [type, body] = files[request.url ?? ""] ?? ["text/plain", ""];
      response.setHeader("content-type", type).end(body);
    }
  });
  await new Promise((resolve) =>
    server.listen(0, "127.0.0.1", () => {
      resolve(undefined);
    }),
  );
  const address = server.address();
  const port = address && typeof address === "object" ? address.port : 0;
  const profile = mkdtempSync(join(tmpdir(), "precess-bench-"));
  const flags =
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking" +
    " --disable-component-update --disable-sync";
  const child = spawn(
    chromium,
    [...flags.split(" "), `--user-data-dir=${profile}`, `http://127.0.0.1:${port}/`],
    { stdio: "ignore" },
  );
  /** @type {Promise<never>} */
  const gone = new Promise((_, reject) => {
    for (const end of ["exit", "error"]) {
      child.once(end, () => {
        reject(new Error("the browser has ended"));
      });
    }
  });
  // Nobody may be waiting when it does.
  gone.catch(() => undefined);
  await Promise.race([attending, gone]);
  return {
    /** @returns {Promise<Timing>} */
    async ask(/** @type {string} */ wanted) {
      while (!next) await Promise.race([gone, new Promise((resolve) => setTimeout(resolve, 5))]);
      const tell = next;
      next = undefined;
      /** @type {Promise<Timing>} */
      const timing = new Promise((resolve) => {
        done = resolve;
        tell(wanted);
      });
      return Promise.race([timing, gone]);
    },
    close() {
      child.on("exit", () => {
        // Its children write there for a moment longer.
        void rm(profile, { recursive: true, force: true, maxRetries: 10 });
      });
      child.kill();
      server.close();
      server.closeAllConnections();
    },
  };
}
