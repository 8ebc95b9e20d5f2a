// Times how long the map of the magnets takes from a move of a magnet to the first picture of the new map on screen, in
// Chromium: from a map at rest, and in the midst of a drag, while the map of the move before is being refined.
//
// Usage: npm run build && node bench/drag.js [MOVES]

// @ts-check
import { chromium as playwright } from "@playwright/test";
import { cpus, loadavg } from "node:os";
import { preview } from "vite";
import { chromium } from "../tools/chromium.js";

const moves = Number(process.argv[2] ?? 21);
const POINTS = 96 ** 2;

/** In the page: hears when a map is asked for, answered and painted. */
function listen() {
  let [asked, before, moved, answered] = [0, 0, NaN, false];
  /** @type {(milliseconds: number) => void} */
  let shown = () => undefined;
  const Plain = Worker;
  window.Worker = class extends Plain {
    /** @param {ConstructorParameters<typeof Worker>} from */
    constructor(...from) {
      super(...from);
      this.addEventListener("message", (/** @type {MessageEvent<{ round?: number }>} */ { data }) => {
        answered ||= (data.round ?? 0) > before;
      });
    }
    /**
     * @param {{ round?: number }} message
     * @override
     */
    postMessage(message) {
      asked = Math.max(asked, message.round ?? 0);
      super.postMessage(message);
    }
  };
  const pens = CanvasRenderingContext2D.prototype;
  // eslint-disable-next-line @typescript-eslint/unbound-method -- it gets its pen
  pens.putImageData = new Proxy(pens.putImageData, {
    /** @param {CanvasRenderingContext2D} pen */
    apply(put, pen, all) {
      Reflect.apply(put, pen, all);
      if (!answered || !pen.canvas.matches("[data-map-picture]")) return;
      answered = false;
      // The task after the frame in which it was painted.
      setTimeout(() => {
        shown(performance.now() - moved);
      });
    },
  });
  Object.assign(window, {
    next: () =>
      new Promise((resolve) => {
        shown = resolve;
        addEventListener(
          "pointermove",
          () => ([moved, before, answered] = [performance.now(), asked, false]),
          { capture: true, once: true },
        );
      }),
  });
}

const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "warn" });
// The page has nothing in three dimensions: what a graphics card would do is better left out than imitated.
const browser = await playwright.launch({ ...chromium, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1280, height: 1400 }, reducedMotion: "reduce" });
await page.addInitScript(listen);
await page.goto(server.resolvedUrls?.local[0] ?? "");
const choice = page.locator("[data-system=magnetic_pendulum]");
await choice.waitFor({ state: "attached" });
await choice.evaluate((/** @type {HTMLElement} */ one) => {
  one.click();
});
await page.locator("[data-scene=magnetic_pendulum]").waitFor();
await page.locator("[data-map]").click();
const rested = () => page.locator(`[data-map-picture][data-done="${POINTS}"]`).waitFor({ timeout: 120_000 });
await rested();

console.log(`${cpus()[0]?.model}, ${cpus().length} cores; load ${loadavg()[0]?.toFixed(1)} before the drags`);
for (const [place, figure] of /** @type {const} */ ([
  ["on the map", "[data-map-picture]"],
  ["in the scene", "[data-scene]"],
])) {
  for (const still of [true, false]) {
    const handle = page.locator(`figure:has(${figure}) [data-handle^='magnets 1']`);
    await handle.scrollIntoViewIfNeeded();
    const box = await handle.boundingBox();
    if (!box) throw new Error(`no magnet ${place}`);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    const times = [];
    for (let k = 0; k < moves; k++) {
      if (still) await rested();
      const shown = await page.evaluateHandle(() => {
        const next = /** @type {() => Promise<number>} */ (Reflect.get(window, "next"));
        return { time: next() };
      });
      await page.mouse.move(x, y + (k % 2 ? 0 : 8));
      times.push(await shown.evaluate(({ time }) => time));
    }
    await page.mouse.up();
    times.sort((a, b) => a - b);
    const [least, middle, most] = [times[0], times[moves >> 1], times.at(-1)].map((time) => time?.toFixed(0));
    console.log(`${place}, ${still ? "at rest" : "midst of a drag"}: ${middle} ms (${least} to ${most})`);
    await rested();
  }
}
console.log(`load ${loadavg()[0]?.toFixed(1)} after them`);
await browser.close();
await server.close();
