// The part of a map that is shown.

import { expect, test } from "vitest";
import { between, inside, moved, placeAt, shareOf, tidy, zoomed, type Window } from "../src/lab/window";

const WHOLE: Window = { centre: [0, 0], half: [2, 4] };

test("a place and its share of the picture are each other's inverse", () => {
  const window: Window = { centre: [1, -1], half: [0.5, 0.25] };
  expect(shareOf(window, [0.5, -0.75])).toEqual([0, 0]);
  expect(placeAt(window, [0, 0])).toEqual([0.5, -0.75]);
  expect(placeAt(window, shareOf(window, [1.2, -1.1]))).toEqual([1.2, -1.1]);
});

test("places have as many digits as the window shows", () => {
  expect(tidy(WHOLE, [0.123456, -0.123456])).toEqual([0.123, -0.123]);
  const close: Window = { centre: [0.123456, 0], half: [1e-6, 1e-6] };
  expect(tidy(close, [0.123456123456, 0])).toEqual([0.123456123, 0]);
  expect(inside(close, [3, -3])).toEqual([0.123457, -1e-6]);
});

test("a zoom keeps the place under the pointer, and its inverse leads back", () => {
  const about: [number, number] = [1.5, -2];
  const close = zoomed(WHOLE, 2, about, WHOLE);
  expect(close.half).toEqual([1, 2]);
  expect(shareOf(close, about)).toEqual(shareOf(WHOLE, about));
  expect(zoomed(close, 0.5, about, WHOLE)).toEqual(WHOLE);
});

test("a zoom ends where doubles do", () => {
  let window = WHOLE;
  for (let k = 0; k < 200; k++) window = zoomed(window, 2, [1, 1], WHOLE);
  expect(window.half[0]).toBeGreaterThan(1e-9);
  expect(window.half[0]).toBeLessThan(1e-8);
  const [x] = [window.centre[0] - window.half[0], window.centre[0] + window.half[0] / 1000];
  expect(x).toBeLessThan(window.centre[0]);
});

test("a rectangle becomes a window of the old shape about its middle", () => {
  expect(between(WHOLE, [0, 0], [1, 1], WHOLE)).toEqual({ centre: [0.5, 0.5], half: [0.5, 1] });
  expect(moved(WHOLE, [0.5, 0])).toEqual({ centre: [1, 0], half: [2, 4] });
});
