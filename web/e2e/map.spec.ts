// The map of starts.

import { expect, test } from "@playwright/test";
import { barriers, choose, drawing, open } from "./page";

test("a map of starts fills itself, coarse first, and a click opens the run from there", async ({ page }) => {
  await open(page);
  await choose(page, "magnetic_pendulum");
  await page.locator("[data-map]").click();
  const picture = page.locator("[data-map-picture]");
  await expect(picture).toHaveAttribute("data-done", String(96 ** 2), { timeout: 25_000 });
  expect(await barriers(page, "main")).toEqual([]);
  const colours = await drawing(page, "[data-map-picture]");
  await picture.click({ position: { x: 60, y: 60 } });
  await expect(page.locator("[data-field=x]")).toHaveValue(/^-\d/);
  await expect(page.locator("[data-field=y]")).toHaveValue(/^\d/);
  // A click changes the run, not the map.
  await expect(picture).toHaveAttribute("data-done", String(96 ** 2));
  expect(await drawing(page, "[data-map-picture]")).toBe(colours);
  // Without colours the basins are told apart by what is drawn on them.
  await page.locator("[data-patterns]").click();
  await expect.poll(() => drawing(page, "[data-map-picture]")).not.toBe(colours);
});

test("a magnet is moved on the map, by hand and by key, and the map is drawn anew", async ({ page }) => {
  await open(page);
  await choose(page, "magnetic_pendulum");
  await page.locator("[data-map]").click();
  const field = page.locator("[data-field=magnets]");
  const magnet = page.locator("[data-handle^='magnets 1']");
  await expect(page.locator("[data-map-picture]")).not.toHaveAttribute("data-done", "0");
  const before = await drawing(page, "[data-map-picture]");
  await magnet.scrollIntoViewIfNeeded();
  const box = await magnet.boundingBox();
  if (!box) throw new Error("no magnet");
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  for (const k of [1, 2, 3]) await page.mouse.move(box.x + 12 + 15 * k, box.y + 12 - 20 * k);
  await page.mouse.up();
  await expect(field).toHaveValue(/^\[\[0\.[6-9]\d*; 0\.[1-4]\d*; 1\]; \[-0\.25; 0\.433; 1\]/);
  await expect.poll(() => drawing(page, "[data-map-picture]")).not.toBe(before);
  // The whole drag is one step, and each press of a key another.
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(field).toHaveValue("[[0.5; 0; 1]; [-0.25; 0.433; 1]; [-0.25; -0.433; 1]]");
  await magnet.focus();
  await page.keyboard.press("ArrowLeft");
  await expect(field).toHaveValue(/^\[\[0\.4\d*; 0; 1\]/);
  await expect(page.locator("[data-handle^='magnets 1']")).toBeFocused();
});
