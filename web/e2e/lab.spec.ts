import AxeBuilder from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { readFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { decode } from "../src/lab/link";
import { load } from "../tests/builds";

/** Anything that goes wrong in the page fails the test that opened it. */
async function open(page: Page, hash = ""): Promise<void> {
  page.on("pageerror", (error) => {
    throw error;
  });
  await page.goto(`./${hash}`);
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", "", { timeout: 15_000 });
  // The rest of the catalogue comes after the first page.
  await page.locator("[data-system=pendulum]").waitFor({ state: "attached", timeout: 15_000 });
}

/** What axe finds wrong, as it is to be read in a failure. */
async function barriers(page: Page, part = "html"): Promise<unknown[]> {
  const { violations } = await new AxeBuilder({ page }).include(part).analyze();
  return violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)]);
}

/** The text of the file that a click hands out. */
async function taken(page: Page, selector: string): Promise<{ name: string; bytes: Buffer }> {
  const waiting = page.waitForEvent("download");
  await page.locator(selector).click();
  const file = await waiting;
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

const hashOf = (page: Page) => page.locator("[data-run]").getAttribute("data-run");

async function choose(page: Page, id: string): Promise<void> {
  const before = await hashOf(page);
  const button = page.locator(`[data-system=${id}]`);
  // Its family may be folded.
  await button.evaluate((node) => node.closest("details")?.setAttribute("open", ""));
  await button.click();
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
}

async function fill(page: Page, field: string, text: string): Promise<void> {
  const input = page.locator(`[data-field=${field}]`);
  await input.fill(text);
  await input.press("Enter");
}

/** The colours in a canvas, coarsely: one that is blank has one. */
async function picture(page: Page, selector: string): Promise<string> {
  return page.locator(selector).evaluate((canvas: HTMLCanvasElement) => {
    const small = document.createElement("canvas");
    [small.width, small.height] = [120, 60];
    const pen = small.getContext("2d");
    pen?.drawImage(canvas, 0, 0, 120, 60);
    return Array.from(pen?.getImageData(0, 0, 120, 60).data ?? []).join();
  });
}

/** All that is on a canvas. */
const drawing = (page: Page, selector: string) =>
  page.locator(selector).evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

test("a top precesses on the first page, without a click", async ({ page }) => {
  await open(page);
  await expect(page.locator("[data-scene=gyroscope]")).toBeVisible();
  await page.waitForTimeout(500);
  const before = await picture(page, "[data-scene]");
  expect(new Set(before.split(",")).size).toBeGreaterThan(20);
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
  test.setTimeout(150_000);
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
  await page.locator("[data-take] summary").click();
  await expect(page.locator("[data-take] code").first()).toContainText("precess run pendulum --every 0.005");
  const table = (await taken(page, "[data-take] button:has-text('CSV')")).bytes.toString();
  expect(table.split("\n")[0]).toMatch(/^t,theta,theta_dot/);
  const toml = (await taken(page, "[data-take] button:has-text('TOML')")).bytes.toString();
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

test("ten seconds of anything break nothing", async ({ page }) => {
  test.setTimeout(60_000);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  // A small generator of its own, so that a failure can be had again.
  let seed = 7;
  const random = (below: number) => (seed = (seed * 48271) % 2147483647) % below;
  const keys = [
    "Tab",
    "Enter",
    " ",
    "ArrowRight",
    "ArrowDown",
    "f",
    "r",
    "d",
    "9",
    "-",
    "Escape",
    "Backspace",
  ];
  const until = Date.now() + 10_000;
  while (Date.now() < until) {
    const [x, y] = [random(1280), 70 + random(800)];
    const kind = random(4);
    if (kind === 0) await page.mouse.click(x, y);
    else if (kind === 1) await page.keyboard.press(keys[random(keys.length)] ?? "Tab");
    else if (kind === 2) await page.mouse.wheel(0, random(600) - 300);
    else {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + random(200) - 100, y + random(200) - 100, { steps: 3 });
      await page.mouse.up();
    }
  }
  await page.goto("about:blank");
  await page.goto("./");
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", "");
});

test("a link made in the page gives the same bits in the core", async ({ page }) => {
  await open(page);
  await choose(page, "double_pendulum");
  await fill(page, "theta1", "2,5");
  await fill(page, "l2", "7/10");
  await expect.poll(() => page.url()).toContain("#1.");
  await page.waitForTimeout(300);
  const shown = await hashOf(page);
  const decoded = decode(new URL(page.url()).hash);
  if (!decoded || !("text" in decoded)) throw new Error("no scenario in the link");
  expect(decoded.text).toContain("theta1 = 2.5");
  const run = (await load("precess")).run(decoded.text);
  expect(run.hash()).toBe(shown);
  // Whoever opens it sees the same.
  const other = await page.context().newPage();
  await open(other, new URL(page.url()).hash);
  expect(await hashOf(other)).toBe(shown);
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

test("methods can be compared, and equations read", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  await page.locator("[data-rival=euler]").check();
  await expect(page.getByText(/evaluations/)).toHaveCount(2);
  await page.getByRole("button", { name: "Equations", exact: true }).click();
  await expect(page.locator(".katex").first()).toBeVisible();
});

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
      await page.locator("[data-take] summary").click();
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
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    expect(wide).toBe(false);
    expect(await barriers(page)).toEqual([]);
  });
});

test.describe("reduced motion", () => {
  test.use({ contextOptions: { reducedMotion: "reduce" } });
  test("starts paused", async ({ page }) => {
    await open(page);
    await expect(page.locator("[data-play]")).toHaveAccessibleName("Play");
  });
});

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

test("an exercise is answered, checked by the simulation, opened and printed", async ({ page }) => {
  await open(page);
  await page.locator("[data-exercise-list]").click();
  const card = page.locator("[data-exercise=taut-string]");
  const field = card.getByLabel("Your answer");
  await field.fill("6");
  await field.press("Enter");
  await expect(card.locator("[data-verdict=small]")).toContainText("Too small");
  await field.fill("much");
  await field.press("Enter");
  await expect(card.getByRole("status")).toContainText("not a number");
  await field.fill("(5*9,81)^0.5");
  await card.getByRole("button", { name: "Check" }).click();
  await expect(card.locator("[data-verdict=right]")).toContainText("7.0036 rad/s");
  expect(await barriers(page, "[data-exercises]")).toEqual([]);
  await card.getByRole("button", { name: "Open the run" }).click();
  await expect(page.locator("[data-field=theta_dot]")).toHaveValue("5");
  await page.getByLabel("This system only").check();
  await expect(page.locator("[data-exercise=ellipse]")).toHaveCount(0);
  await page.emulateMedia({ media: "print" });
  await expect(card).toBeVisible();
  await expect(page.locator("[data-scene]")).toBeHidden();
  await expect(page.locator("[data-system]").first()).toBeHidden();
});

test("a free body is shown as Poinsot saw it, too", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "free_body");
  let before = "";
  for (const title of ["Scene", "Ellipsoid on its plane", "Two cones"]) {
    await page.locator("[data-which]").selectOption(title);
    await expect.poll(() => picture(page, "[data-scene]")).not.toBe(before);
    before = await picture(page, "[data-scene]");
    expect(new Set(before.split(",")).size).toBeGreaterThan(20);
  }
  await choose(page, "pendulum");
  await expect(page.locator("[data-which]")).toHaveCount(0);
});
