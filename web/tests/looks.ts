// Runs as the views see them, and an ink to draw them with.

import type { Ink } from "../src/draw/ink";
import { columnsOf } from "../src/lab/columns";
import { Look } from "../src/lab/result";
import { scenarioOf } from "../src/lab/toml";
import { load } from "./builds";

const core = await load("precess");

export const ink: Ink = {
  paper: "#fff",
  ink: "#000",
  faint: "#888",
  grid: "#eee",
  accent: "#f00",
  curves: ["#001", "#002", "#003", "#004", "#005"],
  dark: false,
  font: "serif",
  weight: 1,
};

/** Runs a scenario. */
export function lookAt(text: string): Look {
  const run = core.run(text);
  const [report, numbers, events] = [run.report, columnsOf(run), run.events()];
  run.free();
  return new Look({ scenario: scenarioOf(text), report, hash: "", events, numbers });
}
