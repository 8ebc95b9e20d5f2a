import { expect, test } from "vitest";
import { drawPlot } from "../src/draw/plot";
import { SvgBrush } from "../src/draw/svg";
import { measured } from "../src/lab/measured";
import { ink } from "./looks";

const read = (text: string) => measured("swing.csv", text, ["theta", "theta_dot", "energy"], "en");

test("names, units, commas: as the terminal reads them", () => {
  const wanted = new Map([
    ["t", new Float64Array([0, 0.5])],
    ["theta", new Float64Array([1, -2.5e-3])],
  ]);
  expect(read("t,theta [rad]\n0, 1\n0.5,-2.5e-3\n").columns).toEqual(wanted);
  expect(read("\ufefft;theta\r\n# filmed\r\n0;1\r\n0,5;-0,0025\r\n").columns).toEqual(wanted);
  // What the run does not have is left alone, numbers or not.
  expect(read("frame,t,theta\na,0,1\nb,0.5,-2.5e-3").columns).toEqual(wanted);
});

test.each([
  ["t,theta\n0,1\n0.5,\n", "Line 3: theta is no number ('')"],
  ["t,theta\n0,1\n\nx,2\n", "Line 4: t is no number ('x')"],
  ["t;theta\n0;1e999", "Line 2: theta is no number ('1e999')"],
  ["t,angle\n0,1\n", "theta, theta_dot, energy"],
  ["theta\n1\n", "one of them t"],
  ["t,theta\n", "one of them t"],
  ["", "one of them t"],
])("%j is refused in a sentence", (text, why) => {
  expect(() => read(text)).toThrow(why);
});

test("points lie in the graph as rings, and the graph is wide enough for them", () => {
  const curve = { x: new Float64Array([0, 1]), y: new Float64Array([0, 1]), colour: 0 };
  const picture = (points: (typeof curve)[]) => {
    const brush = new SvgBrush();
    const frame = drawPlot(
      { pen: brush, w: 400, h: 300 },
      { curves: [curve], points, x: "t", y: ["theta"], equal: false },
      ink,
      "en",
    );
    return { frame, rings: brush.elements.match(/A3 3 0 1 1 [^Z]*Z/g)?.length ?? 0, text: brush.elements };
  };
  const far = { x: new Float64Array([0.5, 3, 2]), y: new Float64Array([0.5, 7, -2]), colour: 0 };
  const [bare, full] = [picture([]), picture([far])];
  expect(full.frame.x[1]).toBeGreaterThan(2.9);
  expect(full.frame.y[0]).toBeLessThan(-2);
  expect(full.frame.y[1]).toBeGreaterThan(7);
  expect(bare.frame.y[1]).toBeLessThan(2);
  expect(full.text).not.toContain("NaN");
  expect(bare.rings).toBe(0);
  expect(full.rings).toBe(3);
});
