// The simulation's answers to the exercises, against closed forms where there are some, and their words.

import { expect, test } from "vitest";
import { answer, typed, verdict } from "../src/exercises/answer";
import { EXERCISES } from "../src/exercises/cards";
import { load } from "./builds";
import { lookAt } from "./looks";

const core = await load("precess");

const compute = (text: string) => Promise.resolve(lookAt(text));

/** The complete elliptic integral K(k), by the arithmetic-geometric mean. */
function elliptic(k: number): number {
  let [a, b] = [1, Math.sqrt(1 - k * k)];
  for (let step = 0; step < 8; step++) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return Math.PI / (2 * a);
}

const G = 9.81;
const turn = 2 * Math.PI;
/** What pencil and paper say; the exercises that are not here have no closed form. */
const closed: Record<string, number> = {
  "simple-period": turn / 3,
  "large-swing": 4 * elliptic(Math.sin((49 * Math.PI) / 100)),
  ellipse: 1 / 2,
  "speed-below": Math.sqrt(2 * G * (1 - Math.cos(Math.PI / 3))),
  "spring-period": turn * Math.sqrt(0.5 / 8),
  "hanging-spring": 0.2 + (2 * 0.1 * G) / 4,
  "damped-period": turn / Math.sqrt(1 - 0.6 ** 2),
  "over-the-hill": 1 / Math.sqrt(3),
  resonance: 1 / 0.2,
  "two-planets": turn * Math.sqrt((1 - 1.98 ** 2 / 11) ** -3 / 11),
  "thrown-round": 2 * Math.sqrt(G),
  "taut-string": Math.sqrt(5 * G),
  "slack-string": Math.acos(-2 / 3),
  tension: 2 * G,
  waterwheel: Math.sqrt((1.5 * Math.PI * G) / 10 - 1),
  stretched: 1 + (2 * 0.2 * 0.098) / 0.1,
};
/** The classical Runge-Kutta method of our own for x'' = a(x, x'), until a condition holds. */
function runge(
  a: (x: number, v: number) => number,
  x: number,
  v: number,
  h: number,
  on: (x: number) => boolean,
) {
  const times: number[] = [];
  let largest = 0;
  for (let t = 0; on(x) && t < 400; t += Math.abs(h)) {
    const before = x;
    const [k1, l1] = [v, a(x, v)];
    const [k2, l2] = [v + (h / 2) * l1, a(x + (h / 2) * k1, v + (h / 2) * l1)];
    const [k3, l3] = [v + (h / 2) * l2, a(x + (h / 2) * k2, v + (h / 2) * l2)];
    const [k4, l4] = [v + h * l3, a(x + h * k3, v + h * l3)];
    x += (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
    v += (h / 6) * (l1 + 2 * l2 + 2 * l3 + l4);
    if (before < 0 && x >= 0) times.push(t - (h * before) / (x - before));
    if (t > 300) largest = Math.max(largest, x);
  }
  return { v, largest, period: (times.at(-1) ?? NaN) - (times.at(-2) ?? NaN) };
}
const valley = (x: number, v: number) => -0.17 * v - x + x * x;
const vanDerPol = (e: number) =>
  runge(
    (x, v) => e * (1 - x * x) * v - x,
    2,
    0,
    0.002,
    () => true,
  );
/** Back in time from beside the top of the hill, along the way that ends on it. */
const rate = -0.085 - Math.sqrt(0.085 ** 2 + 1);
const apart = 1e-7;
/** Where a function changes its sign, by halving. */
function root(f: (x: number) => number, low: number, high: number): number {
  for (let k = 0; k < 60; k++) {
    const middle = (low + high) / 2;
    if (f(low) * f(middle) <= 0) high = middle;
    else low = middle;
  }
  return (low + high) / 2;
}
const magnet = (x: number, at: [number, number]) =>
  (at[0] - x) / ((at[0] - x) ** 2 + at[1] ** 2 + 0.2 ** 2) ** 1.5;
const force = (x: number) => -4 * x + magnet(x, [0.5, 0]) + 2 * magnet(x, [-0.25, 0.433]);
/** Hill's discriminant over a period of the shaking: beyond 2 the motion grows. */
function discriminant(alpha: number): number {
  const steps = 4000;
  const h = (2 * Math.PI) / alpha / steps;
  const a = (t: number, x: number) => -(1 - 0.2 * Math.sin(alpha * t)) * x;
  const after = (x: number, v: number) => {
    for (let k = 0; k < steps; k++) {
      // Verlet's steps: time enters at their ends.
      const middle = v + (h / 2) * a(k * h, x);
      x += h * middle;
      v = middle + (h / 2) * a((k + 1) * h, x);
    }
    return [x, v] as const;
  };
  return Math.abs(after(1, 0)[0] + after(0, 1)[1]) - 2;
}
const numeric: Record<string, () => number> = {
  "over-the-hill-damped": () => runge(valley, 1 - apart, -rate * apart, -1e-4, (x) => x > 0).v,
  "limit-cycle": () => vanDerPol(0.1).largest,
  "over-a-magnet": () => root(force, 0.4, 0.5),
  tongue: () => root(discriminant, 2.05, 2.3),
  "relaxation-period": () => vanDerPol(1.6).period,
};

test.each(EXERCISES)("$id: the simulation answers", async ({ id, scenario, asked, tolerance }) => {
  const right = await answer(scenario, asked, compute);
  const [expected, by] = closed[id] === undefined ? [numeric[id]?.() ?? NaN, 1e-3] : [closed[id], 2e-5];
  expect(Math.abs(right / expected - 1), `${right} ${expected}`).toBeLessThan(by);
  expect(verdict(expected, right, tolerance)).toBe("right");
  expect(verdict(right * (1 + 2 * tolerance), right, tolerance)).toBe("large");
  expect(verdict(right * (1 - 2 * tolerance), right, tolerance)).toBe("small");
});

test("answers are read by the core", async () => {
  expect(await typed("2.5", compute)).toBe(2.5);
  expect(await typed("2*pi/3", compute)).toBeCloseTo((2 * Math.PI) / 3, 14);
  expect(await typed("5^0.5", compute)).toBeCloseTo(Math.sqrt(5), 14);
  expect(await typed("90 deg", compute)).toBeCloseTo(Math.PI / 2, 14);
  await expect(async () => typed("much", compute)).rejects.toThrow();
});

test("every card is whole", () => {
  const systems = core.catalogue().systems.map(({ id }) => id);
  expect(new Set(EXERCISES.map(({ id }) => id)).size).toBe(EXERCISES.length);
  for (const { scenario, question, hint } of EXERCISES) {
    expect(systems).toContain(scenario.system);
    for (const text of [question.en, question.fr, hint.en, hint.fr]) expect(text.length).toBeGreaterThan(20);
    expect(question.en).not.toBe(question.fr);
  }
});
