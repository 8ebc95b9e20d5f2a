import { expect, test } from "vitest";
import { groupsOf, listed, MANY } from "../src/lab/groups";
import { load } from "./builds";

const { systems } = (await load("precess")).catalogue();

test("few quantities are listed whole, and of hundreds a few", () => {
  for (const { id, state } of systems) {
    const groups = groupsOf(state);
    if (state.length <= MANY) expect(listed(state, "3"), id).toEqual(state);
    // Whichever group is at hand, all of them together are everything.
    for (const group of groups) expect(listed(state, group).length, id).toBeLessThanOrEqual(MANY);
    const all = groups.flatMap((group) => listed(state, group));
    if (groups.length) expect(new Set(all)).toEqual(new Set(state));
  }
  const cluster = systems.find(({ id }) => id === "cluster")?.state ?? [];
  expect(listed(cluster, "17")).toEqual(["x17", "y17", "x17_dot", "y17_dot"]);
  // A group that is not there is the first one.
  expect(listed(cluster, "")).toEqual(["x0", "y0", "x0_dot", "y0_dot"]);
});
