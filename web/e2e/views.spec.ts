// What stands beside the run: comparisons, vectors, events, exercises.

import { expect, test } from "@playwright/test";
import { bodyIn } from "../src/lab/body";
import { scenarioOf } from "../src/lab/toml";
import { load } from "../tests/builds";
import { barriers, choose, drawing, fill, hashOf, linked, open, picture, taken } from "./page";

test("energies are bars that move with the time", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "pendulum");
  const bars = page.locator("[data-energies]");
  await expect(bars.getByRole("rowheader")).toHaveText(["kinetic", "potential", "energy"]);
  const widths = () => bars.locator("i").evaluateAll((all) => all.map((one) => one.style.width));
  const before = await widths();
  await page.locator("[data-scrub]").fill("200");
  await expect.poll(widths).not.toEqual(before);
  expect((await widths())[2]).toBe(before[2]);
  expect(await barriers(page, "main")).toEqual([]);
  await choose(page, "lorenz");
  await expect(bars).toHaveCount(0);
});

test("methods can be compared, and equations read", async ({ page }) => {
  await open(page);
  await choose(page, "pendulum");
  await page.locator("[data-rival=euler]").check();
  await expect(page.getByText(/evaluations/)).toHaveCount(2);
  await page.getByRole("button", { name: "Equations", exact: true }).click();
  await expect(page.locator(".katex").first()).toBeVisible();
});

test("what a source prints runs beside what is right", async ({ page }) => {
  await open(page);
  await choose(page, "gyroscope_integrals");
  const corrected = await hashOf(page);
  await page.locator("[data-both=formula_21]").check();
  await expect(page.locator("[data-run-of]")).toHaveCount(2);
  await expect(page.locator("[data-run-of='1']")).toContainText(/formula_21 as printed.*evaluations/s);
  await page.locator("[data-printed=formula_21]").click();
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", corrected ?? "");
  await expect(page.locator("[data-run-of='1']")).toContainText(/formula_21 corrected.*evaluations/s);
  await expect(page.locator("[data-printed=formula_21]")).toHaveAttribute("aria-pressed", "true");
  expect(await barriers(page)).toEqual([]);
  await page.locator("[data-corrected=formula_21]").click();
  await expect(page.locator("[data-run]")).toHaveAttribute("data-run", corrected ?? "");
  // Another system has nothing of the kind, and nothing to compare.
  await choose(page, "pendulum");
  await expect(page.locator("[data-run-of]")).toHaveCount(0);
  await expect(page.locator("[data-both]")).toHaveCount(0);
});

test("of hundreds of quantities a few are listed, of the body at hand", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "cluster");
  await expect(page.locator("[data-field=y0_dot]")).toBeVisible();
  await expect(page.locator("[data-field=x9]")).toHaveCount(0);
  await page.locator("[data-group]").selectOption("9");
  await expect(page.locator("[data-field=x9]")).toBeVisible();
  expect(await page.locator("[data-field]").count()).toBeLessThan(20);
  expect(await page.locator("main option").count()).toBeLessThan(120);
  await page.locator("figure:has([data-graph='2']) select").first().selectOption("x9");
  await page.locator("[data-describe]").click();
  await expect(page.locator("[data-spoken]")).toContainText("x of asteroid 9");
  await expect(page.locator("[data-spoken]")).toContainText("544 more numbers are not read");
  // A short run is enough of it.
  await fill(page, "until", "5");
  await expect(page.locator("[data-scrub]")).toHaveAttribute("max", "100");
  const before = await hashOf(page);
  await fill(page, "x9", "200");
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
});

test("vectors stand in a solid scene, and its camera goes along", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  const bare = await drawing(page, "[data-scene]");
  await page.locator("[data-vectors]").click();
  await expect(page.locator("[data-vector=omega]")).toHaveAttribute("aria-pressed", "true");
  await expect.poll(() => drawing(page, "[data-scene]")).not.toBe(bare);
  const some = await drawing(page, "[data-scene]");
  await page.locator("[data-vector=weight]").click();
  await expect.poll(() => drawing(page, "[data-scene]")).not.toBe(some);
  const all = await drawing(page, "[data-scene]");
  await page.locator("[data-view]").selectOption("body");
  await expect.poll(() => drawing(page, "[data-scene]")).not.toBe(all);
  expect(await barriers(page, "main")).toEqual([]);
  await page.locator("[data-view]").selectOption("rest");
  await page.locator("[data-vectors]").click();
  await expect.poll(() => drawing(page, "[data-scene]")).toBe(bare);
  // Another run is another scene, with the same vectors in it.
  await page.locator("[data-vectors]").click();
  await choose(page, "free_body");
  await expect(page.locator("[data-vector=momentum]")).toBeVisible();
  await expect(page.locator("[data-vector=weight]")).toHaveCount(0);
});

test("events are marked along the time bar, and gone to by name", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await expect(page.locator("[data-event]")).toHaveCount(0);
  await choose(page, "noria");
  await expect(page.locator("[data-strip]")).not.toHaveAttribute("data-strip", "0");
  await page.locator("[data-scrub]").fill("0");
  await page.locator("[data-event-on]").click();
  await expect(page.locator("[data-event]")).toContainText("enough water to turn (t = ");
  await expect(page.locator("[data-spoken]")).toContainText("enough water to turn");
  const clock = await page.locator("[data-clock]").textContent();
  await page.locator("[data-event-on]").click();
  await expect(page.locator("[data-clock]")).not.toHaveText(clock ?? "");
  await page.locator("[data-event-back]").click();
  await expect(page.locator("[data-clock]")).toHaveText(clock ?? "");
  // A few events are named in the graphs too.
  await choose(page, "pendulum");
  await page.locator("[data-preset='string-pendulum.toml']").click();
  await expect(page.locator("[data-event]")).toContainText("/ 6");
  expect((await taken(page, "[data-graph-svg='2']")).bytes.toString()).toContain(">slackens<");
  expect(await barriers(page, "main")).toEqual([]);
});

test("an exercise is answered, checked by the simulation, opened and printed", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
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

test("how far a run can be trusted is worked out on demand, and greys what lies beyond", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "double_pendulum");
  await expect(page.locator("[data-beyond]")).toHaveCount(0);
  const bare = await drawing(page, "[data-graph='2']");
  await page.locator("[data-trust]").click();
  const told = page.locator("[data-trusted]");
  await expect(told).toContainText("To be trusted", { timeout: 30_000 });
  expect(await barriers(page, "main")).toEqual([]);
  // A tolerance of a thousandth is soon too much for it.
  await fill(page, "rtol", "1e-3");
  await fill(page, "atol", "1e-3");
  await expect(told).toContainText("To be trusted up to t =", { timeout: 30_000 });
  await expect(page.locator("[data-beyond]")).toHaveCount(1);
  expect(await drawing(page, "[data-graph='2']")).not.toBe(bare);
  await page.locator("[data-scrub]").fill("1000000");
  await expect(page.locator("[data-scrub]")).toHaveAttribute("aria-valuetext", /beyond what can be trusted/);
  // What jumps has no shadow, and says so.
  await choose(page, "noria");
  await expect(told).toContainText("needs a motion without jumps");
  await page.locator("[data-trust]").click();
  await expect(told).toHaveCount(0);
});

test("the polhode and herpolhode of a free body are graphs with a name", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "free_body");
  const select = page.locator("[data-named='2']");
  await select.selectOption({ label: "Herpolhode" });
  await expect(page.getByLabel("Graph 2, horizontally")).toHaveValue("herpolhode_x");
  await expect(page.getByLabel("Graph 2, vertically")).toHaveValue("herpolhode_y");
  expect(await barriers(page, "main")).toEqual([]);
  await select.selectOption("-1");
  await expect(page.getByLabel("Graph 2, horizontally")).toHaveValue("t");
  await choose(page, "pendulum");
  await expect(select).toHaveCount(0);
});

test("a magnet is moved in the scene itself, by hand and by key", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "magnetic_pendulum");
  const field = page.locator("[data-field=magnets]");
  const magnet = page.locator("[data-handle^='magnets 1']");
  const before = await hashOf(page);
  const box = await magnet.boundingBox();
  if (!box) throw new Error("no magnet");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (const k of [1, 2, 3]) await page.mouse.move(box.x + 12 + 10 * k, box.y + 12 - 15 * k);
  await page.mouse.up();
  await expect(field).toHaveValue(/^\[\[0\.[5-9]\d*; 0\.[1-4]\d*; 1\]; \[-0\.25; 0\.433; 1\]/);
  await expect(page.locator("[data-run]")).not.toHaveAttribute("data-run", before ?? "");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(field).toHaveValue("[[0.5; 0; 1]; [-0.25; 0.433; 1]; [-0.25; -0.433; 1]]");
  await magnet.focus();
  await page.keyboard.press("ArrowUp");
  await expect(field).toHaveValue(/^\[\[0\.5; 0\.0\d*; 1\]/);
  await expect(magnet).toBeFocused();
});

test("a profile is drawn and becomes the body, which the link keeps", async ({ page }) => {
  test.setTimeout(120_000);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "heavy_top");
  const bare = await drawing(page, "[data-scene]");
  await page.locator("[data-draw]").click();
  const paper = page.locator("[data-profile]");
  await paper.scrollIntoViewIfNeeded();
  const box = await paper.boundingBox();
  if (!box) throw new Error("no paper");
  const at = (across: number, up: number) =>
    [box.x + (0.5 + across / 2) * box.width, box.y + (1 - up) * box.height] as const;
  await page.mouse.move(...at(0.05, 0.05));
  await page.mouse.down();
  await page.mouse.move(...at(0.8, 0.45), { steps: 3 });
  await page.mouse.move(...at(0.1, 0.95), { steps: 3 });
  await page.mouse.up();
  await expect.poll(() => linked(page)).toMatch(/shape = "smooth_profile"[^]*radii = \[/);
  const drawn = () => bodyIn(scenarioOf(linked(page)))?.radii ?? [];
  await expect.poll(() => drawn()[5] ?? 0).toBeGreaterThan(0.02);
  const middle = drawn()[5] ?? 0;
  await expect.poll(() => drawing(page, "[data-scene]")).not.toBe(bare);
  // By keys, and back.
  await page.locator("[data-slice='5']").focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => drawn()[5]).toBeCloseTo(middle + 0.0001, 6);
  await expect
    .poll(async () => (await load("precess")).run(linked(page)).hash() === (await hashOf(page)))
    .toBe(true);
  expect(await barriers(page)).toEqual([]);
  await page.locator("[data-body-away]").click();
  await expect.poll(() => drawing(page, "[data-scene]")).toBe(bare);
  // On a table a hollow one is refused, in the core's words, and the last good run stays.
  await choose(page, "sliding_body");
  const before = await hashOf(page);
  await page.locator("[data-slice='6']").fill("22");
  await expect.poll(async () => (await hashOf(page)) !== before).toBe(true);
  const good = await hashOf(page);
  await page.locator("[data-slice='6']").fill("2");
  await expect(page.getByRole("alert")).toContainText("hollow");
  expect(await hashOf(page)).toBe(good);
});

test("measured points lie over the graphs, until another system is opened", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  await choose(page, "pendulum");
  const bare = await drawing(page, "[data-graph='2']");
  await page.locator("[data-menu=take] summary").click();
  const put = (text: string) =>
    page
      .locator("[data-open]")
      .setInputFiles({ name: "swing.csv", mimeType: "text/csv", buffer: Buffer.from(text) });
  await put("t;angle\n0;1\n");
  await expect(page.getByRole("status")).toContainText("theta, theta_dot");
  await put("t;theta [rad]\n0;0,5\n1;-0,25\n2,5;0,125\n");
  await expect(page.locator("[data-measured]")).toContainText("swing.csv");
  await expect.poll(() => drawing(page, "[data-graph='2']")).not.toBe(bare);
  expect(await barriers(page)).toEqual([]);
  const svg = (await taken(page, "[data-graph-svg='2']")).bytes.toString();
  expect(svg.match(/A3 3 0 1 1 [^Z]*Z/g)).toHaveLength(3);
  // The menu has folded up, since something else was clicked.
  await page.locator("[data-menu=take] summary").click();
  await page.locator("[data-measured] button").click();
  await expect.poll(() => drawing(page, "[data-graph='2']")).toBe(bare);
  await put("t,theta\n0,1\n");
  await expect(page.locator("[data-measured]")).toBeVisible();
  await choose(page, "duffing");
  await page.locator("[data-menu=take] summary").click();
  await expect(page.locator("[data-menu=take] code").first()).toBeVisible();
  await expect(page.locator("[data-measured]")).toHaveCount(0);
});
