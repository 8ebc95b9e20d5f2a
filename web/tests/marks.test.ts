import { expect, test } from "vitest";
import { drawEvents } from "../src/draw/marks";
import { drawPlot, px } from "../src/draw/plot";
import { SvgBrush } from "../src/draw/svg";
import { marksOf } from "../src/lab/marks";
import { fresh, toml } from "../src/lab/scenario";
import { load } from "./builds";
import { ink, lookAt } from "./looks";

const core = await load("precess");
const noria = core.catalogue().systems.find(({ id }) => id === "noria");
if (!noria) throw new Error("no noria");
const usual = fresh(noria);

test("events are marked at the first sample behind them, in the words of the card", () => {
  const scenario = { ...usual, rest: '[[event]]\nname = "half_round"\nwhen = "theta = 3"\n' };
  const look = lookAt(toml(scenario));
  const marks = marksOf(look, "fr");
  expect(marks.length).toBeGreaterThan(10);
  for (const { t, sample } of marks) {
    expect(look.times[sample]).toBeGreaterThanOrEqual(t);
    if (sample > 0) expect(look.times[sample - 1]).toBeLessThan(t);
  }
  const texts = new Set(marks.map(({ text }) => text));
  expect(texts).toContain("la cuvette 1 arrive sous le filet d'eau");
  // What the scenario watches has a name alone.
  expect(texts).toContain("half round");
});

test("a graph over time has lines and names, another one rings on its curve", () => {
  const look = lookAt(toml(usual));
  const marks = marksOf(look, "en").slice(0, 12);
  const picture = (x: string) => {
    const plot = {
      curves: [{ x: look.column(x), y: look.column("m0"), colour: 0 }],
      x,
      y: ["m0"],
      equal: false,
    };
    const brush = new SvgBrush();
    const frame = drawPlot({ pen: brush, w: 900, h: 300 }, plot, ink, "en");
    const before = brush.elements.length;
    drawEvents(brush, frame, plot, marks, ink);
    return { frame, drawn: brush.elements.slice(before) };
  };
  const { frame, drawn } = picture("t");
  const first = marks.find(({ t }) => px(frame, t) > frame.left + 1);
  if (!first) throw new Error("no mark");
  expect(drawn).toContain(`M${Math.round(px(frame, first.t)) + 0.5} `);
  expect(drawn).toContain(`>${first.name}<`);
  const rings = picture("theta").drawn;
  expect(rings.match(/<path/g)?.length).toBe(marks.length);
  expect(rings).not.toMatch(/<text|NaN/);
});
