// Pictures of the lab, taken in Chromium: `node tools/pictures.js thumbnails` writes the catalogue's, a scene each;
// `node tools/pictures.js screens FOLDER [SYSTEM ...]` writes whole pages, desktop and phone, light and dark.

import { chromium as playwright } from "@playwright/test";
import { mkdirSync, writeFileSync } from "node:fs";
import { preview } from "vite";
import { chromium } from "./chromium.js";

const [task, folder = "screens", ...wanted] = process.argv.slice(2);
const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "warn" });
const address = server.resolvedUrls?.local[0] ?? "";
const browser = await playwright.launch(chromium);

/**
 * A page with the lab in it, at rest.
 * @param {import("@playwright/test").BrowserContextOptions} look
 */
async function open(look) {
  const page = await browser.newPage({ locale: "en-GB", reducedMotion: "reduce", ...look });
  page.on("pageerror", (error) => {
    console.error(error.message);
  });
  await page.goto(address);
  await page.locator("[data-run]:not([data-run=''])").waitFor();
  await page.locator("[data-system=pendulum]").waitFor({ state: "attached" });
  return page;
}

/**
 * A system, at a third of its run.
 * @param {import("@playwright/test").Page} page
 * @param {string} id
 */
async function choose(page, id) {
  const before = await page.locator("[data-run]").getAttribute("data-run");
  const button = page.locator(`[data-system=${id}]`);
  await button.evaluate((/** @type {HTMLElement} */ one) => {
    one.click();
  });
  await page.waitForFunction(
    (old) => document.querySelector("[data-run]")?.getAttribute("data-run") !== old,
    before,
  );
  await page.locator(`[data-scene=${id}]`).waitFor();
  const scrub = page.locator("[data-scrub]");
  await scrub.fill(String(Math.round(Number(await scrub.getAttribute("max")) * 0.31)));
  await page.waitForTimeout(500);
}

/** @param {import("@playwright/test").Page} page */
const systems = (page) =>
  page
    .locator("[data-system]")
    .evaluateAll((buttons) => buttons.map((button) => button.getAttribute("data-system") ?? ""));

if (task === "thumbnails") {
  const to = new URL("../src/thumbnails/", import.meta.url);
  mkdirSync(to, { recursive: true });
  const page = await open({ viewport: { width: 1000, height: 900 }, colorScheme: "light" });
  for (const id of wanted.length ? wanted : await systems(page)) {
    await choose(page, id);
    const scene = page.locator("[data-scene]");
    const data = await scene.evaluate((/** @type {HTMLCanvasElement} */ canvas) => {
      const small = document.createElement("canvas");
      [small.width, small.height] = [168, 108];
      const width = Math.min(canvas.width, (canvas.height * 168) / 108);
      const left = (canvas.width - width) / 2;
      small.getContext("2d")?.drawImage(canvas, left, 0, width, canvas.height, 0, 0, 168, 108);
      return small.toDataURL("image/webp", 0.8);
    });
    writeFileSync(new URL(`${id}.webp`, to), Buffer.from(data.split(",")[1] ?? "", "base64"));
  }
} else {
  mkdirSync(folder, { recursive: true });
  /** @type {Record<string, import("@playwright/test").BrowserContextOptions>} */
  const looks = {
    "desktop-light": { viewport: { width: 1280, height: 860 }, colorScheme: "light" },
    "phone-dark": { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: "dark" },
  };
  for (const [name, look] of Object.entries(looks)) {
    const page = await open(look);
    for (const id of wanted.length ? wanted : await systems(page)) {
      await choose(page, id);
      await page.screenshot({ path: `${folder}/${id}-${name}.png` });
    }
    await page.close();
  }
}
await browser.close();
await server.close();
