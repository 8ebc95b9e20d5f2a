// What goes wrong around the page: no WebGL, a lost graphics context, far too much text.

import { expect, test, type Page } from "@playwright/test";
import { choose, drawing, hashOf, open } from "./page";

const scene = "[data-scene=gyroscope]";
const colours = (page: Page, selector: string) =>
  page
    .locator(selector)
    .first()
    .evaluate((canvas: HTMLCanvasElement) => {
      const small = document.createElement("canvas");
      [small.width, small.height] = [60, 30];
      const pen = small.getContext("2d");
      pen?.drawImage(canvas, 0, 0, 60, 30);
      return new Set(new Uint32Array(pen?.getImageData(0, 0, 60, 30).data.buffer ?? new ArrayBuffer())).size;
    });

test("without WebGL the lab says so, and graphs and flat scenes are there", async ({ page }) => {
  await page.addInitScript(() => {
    const { prototype } = HTMLCanvasElement;
    const plain = Object.getOwnPropertyDescriptor(prototype, "getContext")?.value as (
      this: HTMLCanvasElement,
      kind: string,
      ...rest: unknown[]
    ) => unknown;
    Object.assign(prototype, {
      getContext(this: HTMLCanvasElement, kind: string, ...rest: unknown[]): unknown {
        return kind.startsWith("webgl") ? null : plain.call(this, kind, ...rest);
      },
    });
  });
  await open(page);
  await choose(page, "heavy_top");
  await expect(page.locator("[data-no-scene]")).toContainText("no 3D");
  expect(await colours(page, "canvas[data-graph]")).toBeGreaterThan(3);
  await choose(page, "pendulum");
  await expect(page.locator("[data-scene=pendulum]")).toBeVisible();
  expect(await colours(page, "[data-scene=pendulum]")).toBeGreaterThan(3);
});

test("a graphics context that is lost comes back with its picture", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "gyroscope");
  await expect.poll(() => colours(page, scene)).toBeGreaterThan(20);
  const lost = await page.locator(scene).evaluateHandle((canvas: HTMLCanvasElement) => {
    const extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
    extension?.loseContext();
    return extension;
  });
  await expect.poll(() => colours(page, scene)).toBeLessThan(3);
  await lost.evaluate((extension) => extension?.restoreContext());
  await expect.poll(() => colours(page, scene)).toBeGreaterThan(20);
});

test("ten million letters in a field or a file are refused in a sentence, and nothing is lost", async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "pendulum");
  const before = await hashOf(page);
  const graph = await drawing(page, "[data-scene=pendulum]");
  const field = page.locator("[data-field=theta]");
  await field.evaluate((input: HTMLInputElement) => {
    input.value = "1".repeat(10_000_000);
    input.dispatchEvent(new Event("input", { bubbles: true }));
    input.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await expect(page.getByRole("alert").first()).toBeVisible();
  expect(((await page.getByRole("alert").first().textContent()) ?? "").length).toBeLessThan(400);
  expect(await hashOf(page)).toBe(before);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => drawing(page, "[data-scene=pendulum]")).toBe(graph);
  await page.locator("[data-menu=take] summary").click();
  await page.locator("[data-open]").setInputFiles({
    name: "huge.toml",
    mimeType: "text/plain",
    buffer: Buffer.alloc(10_000_000, "x = 1\n"),
  });
  await expect(page.getByText("larger than any scenario")).toBeVisible();
  expect(await hashOf(page)).toBe(before);
});
