// The map of starts.

import { expect, test, type Page } from "@playwright/test";
import { barriers, choose, drawing, fill, hashOf, open } from "./page";

/** A map of the nearest magnet after short runs, which is done sooner. */
async function quickMap(page: Page) {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "magnetic_pendulum");
  await fill(page, "until", "1.5");
  await page.locator("[data-map]").click();
  await page.locator("[data-map-choice=shown]").selectOption("magnets");
  const picture = page.locator("[data-map-picture]");
  const done = () => expect(picture).toHaveAttribute("data-done", String(96 ** 2), { timeout: 25_000 });
  await done();
  return { picture, done };
}

test("a map of starts fills itself, coarse first, and a click opens the run from there", async ({ page }) => {
  // A scene that moves takes the time of the map.
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "magnetic_pendulum");
  await fill(page, "until", "5");
  await page.locator("[data-map]").click();
  const picture = page.locator("[data-map-picture]");
  await expect(picture).toHaveAttribute("data-done", String(96 ** 2), { timeout: 25_000 });
  expect(await barriers(page, "main")).toEqual([]);
  // The map begins with what is proved, and counts what is not.
  await expect(page.locator("[data-map-choice=shown]")).toHaveValue("*");
  await expect(page.locator("figure li", { hasText: "not proved" })).toHaveText(/ [01](\.\d+)? %/);
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
  const magnet = page.locator("figure:has([data-map-picture]) [data-handle^='magnets 1']");
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
  await expect(page.locator("figure:has([data-map-picture]) [data-handle^='magnets 1']")).toBeFocused();
});

test("after a move a coarse picture of the new map comes first, and gives way to the fine one", async ({
  page,
}) => {
  const { picture, done } = await quickMap(page);
  // What is known, and what is seen, each time that there is more of it.
  await picture.evaluate((canvas: HTMLCanvasElement) => {
    const seen: [number, string][] = [];
    new MutationObserver(() => seen.push([Number(canvas.dataset["done"]), canvas.toDataURL()])).observe(
      canvas,
      {
        attributes: true,
        attributeFilter: ["data-done"],
      },
    );
    Object.assign(window, { seen });
  });
  await page.locator("figure:has([data-map-picture]) [data-handle^='magnets 1']").focus();
  await page.keyboard.press("ArrowLeft");
  await expect(picture).not.toHaveAttribute("data-done", String(96 ** 2));
  await done();
  const seen = await page.evaluate(() => (window as unknown as { seen: [number, string][] }).seen);
  const known = seen.map(([points]) => points);
  expect(known[0]).toBeLessThan(96 ** 2 / 4);
  expect(known).toEqual(known.toSorted((a, b) => a - b));
  expect(seen[0]?.[1]).not.toBe(seen.at(-1)?.[1]);
});

test("a map is looked at closer, by a rectangle, wheel, keys and buttons, and back", async ({ page }) => {
  const { picture, done } = await quickMap(page);
  const extent = () => picture.getAttribute("aria-label");
  const [whole, colours] = [await extent(), await drawing(page, "[data-map-picture]")];
  const before = await hashOf(page);
  await picture.scrollIntoViewIfNeeded();
  const box = await picture.boundingBox();
  if (!box) throw new Error("no map");
  await page.mouse.move(box.x + 60, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 160, box.y + 160, { steps: 3 });
  await page.mouse.up();
  await expect.poll(extent).toMatch(/x −[\d.]+ … −[\d.]+/);
  await expect.poll(() => drawing(page, "[data-map-picture]")).not.toBe(colours);
  await done();
  // A rectangle opens no run.
  expect(await hashOf(page)).toBe(before);
  await page.locator("[data-zoom=back]").click();
  expect(await extent()).toBe(whole);
  await expect(page.locator("[data-zoom=back]")).toBeDisabled();
  await picture.focus();
  await page.keyboard.press("+");
  await page.keyboard.press("ArrowRight");
  const moved = await extent();
  expect(moved).not.toBe(whole);
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.wheel(0, -300);
  await expect.poll(extent).not.toBe(moved);
  await page.keyboard.press("Backspace");
  await expect.poll(extent).toBe(moved);
  await page.keyboard.press("0");
  await expect.poll(extent).toBe(whole);
  await done();
  await expect.poll(() => drawing(page, "[data-map-picture]")).toBe(colours);
  expect(await barriers(page, "main")).toEqual([]);
});

test("where a map would take minutes, none is drawn, and that is said", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "cluster");
  await page.locator("[data-map]").click();
  await expect(page.locator("[data-map-large]")).toContainText("No map is drawn here");
  await expect(page.locator("[data-map-picture]")).toHaveCount(0);
  await choose(page, "pendulum");
  await expect(page.locator("[data-map-large]")).toHaveCount(0);
  await expect(page.locator("[data-map-picture]")).not.toHaveAttribute("data-done", "0");
});
