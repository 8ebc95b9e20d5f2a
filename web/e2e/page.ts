// What the tests do with a page of the lab.

import AxeBuilder from "@axe-core/playwright";
import { expect, type Page } from "@playwright/test";
import { createHash } from "node:crypto";
import { readFile } from "node:fs/promises";
import { decode } from "../src/lab/link";

/** Anything that goes wrong in the page fails the test that opened it. */
export async function open(page: Page, hash = ""): Promise<void> {
  page.on("pageerror", (error) => {
    throw error;
  });
  await page.goto(`./${hash}`);
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", "", { timeout: 15_000 });
  // The rest of the catalogue comes after the first page.
  await page.locator("[data-system=pendulum]").waitFor({ state: "attached", timeout: 15_000 });
}

/** What axe finds wrong, as it is to be read in a failure. */
export async function barriers(page: Page, part = "html"): Promise<unknown[]> {
  const { violations } = await new AxeBuilder({ page }).include(part).analyze();
  return violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)]);
}

/** The text of the file that a click hands out. */
export async function taken(page: Page, selector: string): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.waitForEvent("download");
  await page.locator(selector).click();
  const file = await waiting;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

export const hashOf = (page: Page) => page.locator("[data-run]").getAttribute("data-run");

/** The scenario in the page's address. */
export function linked(page: Page): string {
  const decoded = decode(new URL(page.url()).hash);
  return decoded && "text" in decoded ? decoded.text : "";
}

export async function choose(page: Page, id: string): Promise<void> {
  const before = await hashOf(page);
  const button = page.locator(`[data-system=${id}]`);
  // Its family may be folded.
  await button.evaluate((node) => node.closest("details")?.setAttribute("open", ""));
  await button.click();
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
  // An earlier run may have ended just then.
  await page.locator(`[data-scene=${id}], [data-no-scene=${id}]`).waitFor();
}

export async function fill(page: Page, field: string, text: string): Promise<void> {
  const input = page.locator(`[data-field=${field}]`);
  await input.fill(text);
  await input.press("Enter");
}

/** The colours in a canvas, coarsely: one that is blank has one. */
export async function picture(page: Page, selector: string): Promise<string> {
  return page.locator(selector).evaluate((canvas: HTMLCanvasElement) => {
    const small = document.createElement("canvas");
    [small.width, small.height] = [120, 60];
    const pen = small.getContext("2d");
    pen?.drawImage(canvas, 0, 0, 120, 60);
    return Array.from(pen?.getImageData(0, 0, 120, 60).data ?? []).join();
  });
}

/** What is on a canvas, to be held against what was. */
export const drawing = async (page: Page, selector: string) => {
  const url = await page.locator(selector).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  return createHash("sha256").update(url).digest("hex");
};
