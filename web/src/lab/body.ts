// A body that was drawn: the radii of a profile in a scenario's `[system.body]`, where links and files keep it.

import type { Scenario } from "./scenario";
import { exact } from "./scenario";

export interface Drawn {
  /** In m. */
  height: number;
  /** In kg/m^3. */
  density: number;
  /** At the middles of slices of equal thickness, from below; in m. */
  radii: readonly number[];
}

const SECTION = /^\[system\.body\][^\n]*\n(?:(?![ \t]*\[)[^\n]*(?:\n|$))*/m;
/** What a body gives; given besides it would be given twice. */
const GIVEN = /^(m|i\d+|centre|about|point\d|radius|axis\d)$/;

/** Whether a scenario has a body of its own, drawn or otherwise. */
export const hasBody = ({ rest }: Scenario) => SECTION.test(rest);

/** The profile in a scenario, where there is one in plain numbers. */
export function bodyIn({ rest }: Scenario): Drawn | undefined {
  const section = SECTION.exec(rest)?.[0] ?? "";
  if (!/^shape\s*=\s*"(smooth_)?profile"/m.test(section)) return undefined;
  const value = (name: string) =>
    new RegExp(String.raw`^${name}\s*=\s*([^#\n]*)`, "m").exec(section)?.[1] ?? "";
  const radii = /^\[(.*)\]\s*$/.exec(value("radii"))?.[1]?.split(",").map(Number) ?? [];
  const drawn = { height: Number(value("height")), density: Number(value("density")), radii };
  const numbers = [drawn.height, drawn.density, ...radii];
  return radii.length > 2 && numbers.every((x) => Number.isFinite(x)) ? drawn : undefined;
}

/** With this body, or with none. */
export function withBody(scenario: Scenario, drawn: Drawn | undefined): Scenario {
  const others = scenario.rest.replace(SECTION, "").trim();
  if (!drawn) return { ...scenario, rest: others };
  const section = [
    "[system.body]",
    'shape = "smooth_profile"',
    `density = ${exact(drawn.density)}`,
    `height = ${exact(drawn.height)}`,
    `radii = [${drawn.radii.map(exact).join(", ")}]`,
  ].join("\n");
  const own = Object.entries(scenario.parameters).filter(([name]) => !GIVEN.test(name));
  return {
    ...scenario,
    parameters: Object.fromEntries(own),
    rest: others ? `${section}\n\n${others}` : section,
  };
}

/** Its outline, from the axis below to the axis above, moved by `z`. */
export function outline({ height, radii }: Drawn, z = 0): [radius: number, z: number][] {
  const slice = height / radii.length;
  const [a = 0, b = 0] = radii;
  const [y = 0, x = 0] = radii.slice(-2);
  const inner = radii.map((r, k): [number, number] => [r, z + (k + 0.5) * slice]);
  const end = (near: number, far: number) => Math.max(1.5 * near - 0.5 * far, 0);
  return [[0, z], [end(a, b), z], ...inner, [end(x, y), z + height], [0, z + height]];
}
