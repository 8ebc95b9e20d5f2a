// The lab as a whole: opened, run, taken away, linked, broken.

import { expect, test } from "@playwright/test";
import { gzipSync } from "node:zlib";
import { scenarioOf } from "../src/lab/toml";
import { load } from "../tests/builds";
import { barriers, choose, fill, hashOf, linked, open, picture, taken } from "./page";

test("a top precesses on the first page, without a click", async ({ page }) => {
  await open(page);
  await expect(page.locator("[data-scene=gyroscope]")).toBeVisible();
  await expect
    .poll(async () => new Set((await picture(page, "[data-scene]")).split(",")).size)
    .toBeGreaterThan(20);
  const before = await picture(page, "[data-scene]");
  await expect.poll(() => picture(page, "[data-scene]")).not.toBe(before);
});

test("the first page is small", async ({ page }) => {
  const sizes = new Map<string, number>();
  const bodies: Promise<void>[] = [];
  page.on("response", (response) => {
    const name = response.url().split("/").at(-1) ?? "";
    // The whole core and the catalogue's pictures come once the first picture stands.
    if (/^precess-(?!first)|\.webp$/.test(name)) return;
    bodies.push(response.body().then((body) => void sizes.set(name, gzipSync(body, { level: 9 }).length)));
  });
  await open(page);
  await expect(page.locator("[data-scene=gyroscope]")).toBeVisible();
  await Promise.all(bodies);
  const whole = [...sizes.values()].reduce((sum, size) => sum + size, 0);
  expect(sizes.size).toBeGreaterThan(4);
  expect(whole, JSON.stringify([...sizes])).toBeLessThan(350_000);
});

test("every system opens, is not blank, and moves", async ({ page }) => {
  test.setTimeout(300_000);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  const ids = await page
    .locator("[data-system]")
    .evaluateAll((buttons) => buttons.map((button) => (button as HTMLElement).dataset["system"] ?? ""));
  expect(ids.length).toBeGreaterThanOrEqual(30);
  for (const id of ids) {
    if (id === "gyroscope") continue;
    await choose(page, id);
    await expect(page.locator(`[data-scene=${id}]`)).toBeVisible();
    await expect
      .poll(async () => new Set((await picture(page, "[data-scene]")).split(",")).size, id)
      .toBeGreaterThan(4);
    const before = await picture(page, "[data-scene]");
    const last = Number(await page.locator("[data-scrub]").getAttribute("max"));
    await page.locator("[data-scrub]").fill(String(Math.round(last * 0.37)));
    await expect.poll(() => picture(page, "[data-scene]"), id).not.toBe(before);
    expect(new Set((await picture(page, "[data-graph='2']")).split(",")).size, id).toBeGreaterThan(4);
  }
});

test("a scenario of the program says what to notice, in both languages", async ({ page }) => {
  await open(page);
  await choose(page, "coupled_pendulums");
  await page.locator("[data-preset='beats.toml']").click();
  await expect(page.locator("[data-field=k]")).toHaveValue("0.8");
  await expect(page.getByText("takes all the energy of the first")).toBeVisible();
  await page.locator("[data-language]").click();
  await expect(page.getByText("prend toute l'énergie du premier")).toBeVisible();
  await expect(page).toHaveTitle(/^Battements/);
});

test("what is shown can be taken away: table, scenario, command, picture, drawing, film", async ({
  page,
}) => {
  await open(page);
  await choose(page, "pendulum");
  const png = await taken(page, "[data-save=png]");
  expect(png.name).toBe("pendulum.png");
  expect(png.bytes.subarray(1, 4).toString()).toBe("PNG");
  const svg = (await taken(page, "[data-save=svg]")).bytes.toString();
  expect(svg).toContain("<svg");
  const graph = (await taken(page, "[data-graph-svg='2']")).bytes.toString();
  expect(graph).toContain("theta");
  for (const text of [svg, graph]) expect(text).not.toMatch(/NaN|undefined/);
  await page.locator("[data-save=film]").click();
  await expect(page.locator("[data-save=film]")).toHaveAttribute("aria-pressed", "true");
  await expect(page.locator("[data-clock]")).not.toHaveText("0.000 s");
  const film = await taken(page, "[data-save=film]");
  // The first bytes of every WebM file.
  expect(film.bytes.subarray(0, 4).toString("hex")).toBe("1a45dfa3");
  await page.locator("[data-menu=take] summary").click();
  await expect(page.locator("[data-menu=take] code").first()).toContainText(
    "precess run pendulum --every 0.005",
  );
  const table = (await taken(page, "[data-menu=take] button:has-text('CSV')")).bytes.toString();
  expect(table.split("\n")[0]).toMatch(/^t,theta,theta_dot/);
  const toml = (await taken(page, "[data-menu=take] button:has-text('TOML')")).bytes.toString();
  expect((await load("precess")).run(toml).hash()).toBe(await hashOf(page));
  await page.locator("[data-open]").setInputFiles({
    name: "mine.toml",
    mimeType: "application/toml",
    buffer: Buffer.from(toml.replace("[run]", "[start]\ntheta = 0.25\n\n[run]")),
  });
  await expect(page.locator("[data-field=theta]")).toHaveValue("0.25");
  await page.locator("[data-open]").setInputFiles({
    name: "large.toml",
    mimeType: "application/toml",
    buffer: Buffer.alloc(2 << 20, 35),
  });
  await expect(page.getByRole("status")).toContainText("larger than any scenario");
});

test("within another page there is the scene and the time bar alone", async ({ page }) => {
  await open(page).catch(() => undefined);
  await page.goto("./?ui=none");
  await expect(page.locator("[data-scene]")).toBeVisible();
  await expect(page.locator("[data-scrub]")).toBeVisible();
  await expect(page.locator("[data-system]")).toHaveCount(0);
  await expect(page.locator("[data-graph]")).toHaveCount(0);
  expect(await barriers(page)).toEqual([]);
});

test("after the first visit the lab needs no network", async ({ page, context }) => {
  await open(page);
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await context.setOffline(true);
  await page.reload();
  await choose(page, "lorenz");
  await expect(page.locator("[data-scene=lorenz]")).toBeVisible();
  await page.getByRole("button", { name: "Equations", exact: true }).click();
  await expect(page.locator(".katex").first()).toBeVisible();
});

test("a link made in the page gives the same bits in the core", async ({ page }) => {
  await open(page);
  await choose(page, "double_pendulum");
  await fill(page, "theta1", "2,5");
  await fill(page, "l2", "7/10");
  const core = await load("precess");
  // The page writes its address and shows its run a moment after the fields have changed: both are to be of what was asked.
  const shown = async () => {
    const text = linked(page);
    if (!text) return [];
    const { start, parameters } = scenarioOf(text);
    const run = core.run(text);
    const same = run.hash() === (await hashOf(page));
    run.free();
    return [start["theta1"], parameters["l2"], same];
  };
  await expect.poll(shown, { timeout: 20_000 }).toEqual(["2.5", "7/10", true]);
  const hash = await hashOf(page);
  // Whoever opens it sees the same.
  const other = await page.context().newPage();
  await open(other, new URL(page.url()).hash);
  await expect.poll(() => hashOf(other)).toBe(hash);
});

test("a damaged or newer link says so, and nothing is lost", async ({ page }) => {
  await open(page, "#1.garbage");
  await expect(page.getByRole("status")).toContainText("damaged");
  await choose(page, "pendulum");
  const before = await hashOf(page);
  await page.evaluate(() => (location.hash = "#9.abc"));
  await expect(page.getByRole("status")).toContainText("newer");
  expect(await hashOf(page)).toBe(before);
});

test("scrubbing, stepping, forking and undoing are exact", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  await page.locator("[data-scrub]").fill("200");
  await expect(page.locator("[data-clock]")).toHaveText("1.000 s");
  await page.locator("[data-on]").click();
  await expect(page.locator("[data-clock]")).toHaveText("1.005 s");
  await page.locator("[data-back]").click();
  const before = await hashOf(page);
  await page.locator("[data-fork]").click();
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
  await expect(page.locator("[data-clock]")).toHaveText("0.000 s");
  const run = (await load("precess")).run('precess = 1\n[system]\nid = "pendulum"\n[run]\nevery = 0.005\n');
  await expect(page.locator("[data-field=theta]")).toHaveValue(String(run.column("theta")[200]));
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(page.locator("[data-run]")).toHaveAttribute("data-run", before ?? "");
  await page.getByRole("button", { name: "Redo" }).click();
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
});

test("a mistake is named beside its field, and the last good run stays", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  const before = await hashOf(page);
  await fill(page, "l", "1 kg");
  const field = page.locator("[data-field=l]");
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await expect(page.getByText("a value in m is needed here, not one in kg")).toBeVisible();
  expect(await hashOf(page)).toBe(before);
});

test("dragging the pendulum starts it elsewhere, as one step that can be undone", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  const before = await hashOf(page);
  const box = await page.locator("[data-scene]").boundingBox();
  if (!box) throw new Error("no scene");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y + 80);
  await page.mouse.down();
  for (const dx of [40, 80, 120]) await page.mouse.move(x + dx, y, { steps: 3 });
  await page.mouse.up();
  await expect(page.locator("[data-field=theta]")).toHaveValue("1.571");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(page.locator("[data-run]")).toHaveAttribute("data-run", before ?? "");
});
