// Keyboard, screen reader, language, phone, reduced motion.

import { expect, test } from "@playwright/test";
import { barriers, choose, fill, hashOf, open } from "./page";

test("the keyboard alone plays, steps, forks and describes", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  await page.locator("#timebar").focus();
  await page.keyboard.press(" ");
  await expect(page.locator("[data-play]")).toHaveAccessibleName("Play");
  const clock = await page.locator("[data-clock]").textContent();
  await page.keyboard.press("ArrowRight");
  await expect(page.locator("[data-clock]")).not.toHaveText(clock ?? "");
  await page.keyboard.press("d");
  await expect(page.locator("[data-spoken]")).toContainText("angle from the downward vertical");
  const before = await hashOf(page);
  await page.keyboard.press("f");
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
});

for (const [language, colorScheme] of [
  ["en", "light"],
  ["fr", "dark"],
] as const) {
  test.describe(`${language}, ${colorScheme}`, () => {
    test.use({ locale: language, colorScheme });
    test("has no barrier that axe knows", async ({ page }) => {
      test.setTimeout(90_000);
      // A picture that is drawn anew all the time by software leaves no time for axe.
      await page.emulateMedia({ reducedMotion: "reduce", colorScheme });
      await open(page);
      await expect(page.locator("html")).toHaveAttribute("lang", language);
      await page.locator("[data-menu=take] summary").click();
      await expect(page.locator("[data-menu=take] code").first()).toBeVisible();
      expect(await barriers(page)).toEqual([]);
      await page.keyboard.press("Escape");
      await expect(page.locator("[data-menu=take] code")).toHaveCount(0);
      await page.locator("header .tools > button[aria-pressed]").click();
      await expect(page.locator(".katex").first()).toBeVisible();
      expect(await barriers(page)).toEqual([]);
      await choose(page, "n_body");
      await fill(page, "k", "x");
      await page.locator("[data-rival=euler]").check();
      await expect(page.locator("[aria-invalid]")).toBeVisible();
      expect(await barriers(page)).toEqual([]);
    });
  });
}

test("French has a decimal comma, and the choice stays", async ({ page }) => {
  await open(page);
  await page.locator("[data-language]").click();
  await expect(page.getByRole("heading", { name: "Systèmes" })).toBeVisible();
  await choose(page, "pendulum");
  await expect(page.locator("[data-field=g]")).toHaveValue("9,81");
  await page.reload();
  await expect(page.getByRole("heading", { name: "Systèmes" })).toBeVisible();
});

test.describe("a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });
  test("shows the scene on top and the parameters in a sheet", async ({ page }) => {
    await open(page);
    await expect(page.locator("[data-scene]")).toBeInViewport();
    await expect(page.locator("[data-field=theta]")).toBeHidden();
    await page.getByRole("button", { name: "Parameters" }).click();
    await expect(page.locator("[data-field=theta]")).toBeVisible();
    const wide = () => page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    expect(await wide()).toBe(false);
    expect(await barriers(page)).toEqual([]);
    await choose(page, "noria");
    await expect(page.locator("[data-event]")).toBeVisible();
    const inner = await page.locator("main").evaluate((main) => main.scrollWidth - main.clientWidth);
    expect(inner).toBe(0);
    expect(await wide()).toBe(false);
  });
});

test.describe("reduced motion", () => {
  test.use({ contextOptions: { reducedMotion: "reduce" } });
  test("starts paused", async ({ page }) => {
    await open(page);
    await expect(page.locator("[data-play]")).toHaveAccessibleName("Play");
  });
});
