// The order in which a map is computed, with workers that answer when they are told to.

import { afterEach, expect, test, vi } from "vitest";
import { place, type Axis } from "../src/core/tiles";
import { Mapper } from "../src/lab/mapper";
import type { TileAnswer, TileAsk } from "../src/lab/mapworker";

let asks: { ask: TileAsk; worker: Thread }[] = [];

class Thread {
  onmessage: ((event: { data: TileAnswer }) => void) | undefined;
  postMessage(ask: TileAsk) {
    asks.push({ ask, worker: this });
  }
  terminate() {
    asks = [];
  }
}

/** The oldest tile that is asked for, answered. */
function answer(): Axis[] {
  const [first, ...rest] = asks;
  if (!first) throw new Error("nothing is asked for");
  asks = rest;
  const { round, tile, draft } = first.ask;
  first.worker.onmessage?.({
    data: {
      round,
      tile,
      draft,
      values: [new Float64Array(pointsOf(tile))],
      attractors: { names: [], states: [] },
      refusal: "",
    },
  });
  return tile;
}

const pointsOf = (tile: Axis[]) => tile.reduce((all, { part }) => all * (part?.points ?? NaN), 1);
const axes = (points: number): Axis[] => ["x", "y"].map((name) => ({ name, low: -1, high: 1, points }));

async function open(threads: number) {
  vi.stubGlobal("Worker", Thread);
  vi.stubGlobal("navigator", { hardwareConcurrency: threads + 1 });
  // The smallest module: the threads compute nothing.
  vi.stubGlobal("fetch", () => Promise.resolve(new Response(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]))));
  return Mapper.open();
}

/** A wish for a map, and the tiles that it hears of. */
function wish(points: number) {
  const heard: Axis[][] = [];
  return {
    heard,
    text: "",
    axes: axes(points),
    wanted: { columns: ["x"] },
    told: ({ tile }: TileAnswer) => heard.push(tile),
  };
}

afterEach(() => {
  asks = [];
  vi.unstubAllGlobals();
});

test("a few points all over the map come first, then those in between, each once", async () => {
  for (const points of [96, 192, 384]) {
    const mapper = await open(1);
    const map = wish(points);
    mapper.compute(map);
    const first = answer();
    expect(first.map(({ part }) => part)).toEqual(
      [1, 2].map(() => ({ first: 0, stride: points / 6, points: 6 })),
    );
    while (asks.length) answer();
    const known = new Set(
      map.heard.flatMap((tile) =>
        Array.from({ length: pointsOf(tile) }, (_, member) => place(tile, member).join()),
      ),
    );
    expect(map.heard.reduce((all, tile) => all + pointsOf(tile), 0)).toBe(points ** 2);
    expect(known.size).toBe(points ** 2);
  }
});

test("a map takes the place of another once that one can be recognized, and the newest of several", async () => {
  for (const threads of [1, 3]) {
    asks = [];
    const mapper = await open(threads);
    const [old, passed, newest] = [wish(96), wish(96), wish(96)];
    mapper.compute(old);
    expect(asks.length).toBe(threads);
    answer();
    mapper.compute(passed);
    mapper.compute(newest);
    // Twelve points to each side are recognized.
    for (let known = 36; known < 144; known += pointsOf(answer()));
    expect(old.heard.reduce((all, tile) => all + pointsOf(tile), 0)).toBe(144);
    while (asks.length) answer();
    // What was begun for the old one is heard no more.
    expect(old.heard.length).toBe(4);
    expect(passed.heard.length).toBe(0);
    expect(newest.heard.reduce((all, tile) => all + pointsOf(tile), 0)).toBe(96 ** 2);
    // At rest nothing is waited for.
    const another = wish(96);
    mapper.compute(another);
    answer();
    expect(another.heard.length).toBe(1);
  }
});

test("labels are drafted all over the map first, and then told of every point", async () => {
  const mapper = await open(1);
  const told: { points: number; draft: boolean }[] = [];
  mapper.compute({
    ...wish(96),
    wanted: "labels",
    told: ({ tile, draft }) => told.push({ points: pointsOf(tile), draft }),
  });
  while (asks.length) answer();
  const points = (draft: boolean) =>
    told.filter((tile) => tile.draft === draft).reduce((all, tile) => all + tile.points, 0);
  expect([points(true), points(false)]).toEqual([144, 96 ** 2]);
  expect(told.findIndex(({ draft }) => !draft)).toBe(4);
});
