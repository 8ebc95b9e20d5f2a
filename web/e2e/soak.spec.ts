// Anything at all, for as long as PRECESS_SOAK says in seconds: a minute where it says nothing.

import { expect, test } from "@playwright/test";
import { open } from "./page";

const SECONDS = Number(process.env["PRECESS_SOAK"] ?? 60);
/** What the page may hold at the end beyond what it held after a third of the time, in bytes. */
const GROWTH = 8e6;
const KEYS = ["Tab", "Enter", " ", "ArrowRight", "ArrowDown", "f", "r", "d", "9", "-", "Escape", "Backspace"];

test(`${SECONDS} seconds of anything break nothing, and keep no memory`, async ({ page }) => {
  test.setTimeout((2 * SECONDS + 60) * 1000);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  const session = await page.context().newCDPSession(page);
  const held = async () => {
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize } = await session.send("Runtime.getHeapUsage");
    return usedSize;
  };
  // A small generator of its own, so that a failure can be had again.
  let seed = 7;
  const random = (below: number) => (seed = (seed * 48271) % 2147483647) % below;
  const anything = async (seconds: number) => {
    const until = Date.now() + 1000 * seconds;
    while (Date.now() < until) {
      const [x, y] = [random(1280), 70 + random(800)];
      const kind = random(4);
      if (kind === 0) await page.mouse.click(x, y);
      else if (kind === 1) await page.keyboard.press(KEYS[random(KEYS.length)] ?? "Tab");
      else if (kind === 2) await page.mouse.wheel(0, random(600) - 300);
      else {
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + random(200) - 100, y + random(200) - 100, { steps: 3 });
        await page.mouse.up();
      }
    }
  };
  // Whatever there is comes in at first: systems, scenes, graphs.
  await anything(SECONDS / 3);
  const early = await held();
  await anything((2 * SECONDS) / 3);
  const late = await held();
  console.log(`the page holds ${(early / 1e6).toFixed(1)} MB, then ${(late / 1e6).toFixed(1)} MB`);
  expect(late - early).toBeLessThan(GROWTH);
  await page.goto("about:blank");
  await page.goto("./");
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", "");
});
