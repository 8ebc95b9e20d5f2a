import { readFileSync } from "node:fs";
import { Core } from "../src/core";

/** The two builds of the core, which `make wasm` puts there. */
export const BUILDS = ["precess", "precess-simd128"] as const;

const modules = new Map<string, Promise<WebAssembly.Module>>();

/** A fresh core of a build; the module is compiled once. */
export async function load(build: string): Promise<Core> {
  const file = new URL(`../wasm/${build}.wasm`, import.meta.url);
  const module = modules.get(build) ?? WebAssembly.compile(readFileSync(file));
  modules.set(build, module);
  return Core.load(await module);
}

/** A scenario of a system and its settings, as a person writes it. */
export function scenario(system: string, run: Record<string, string | number>, rest = ""): string {
  const settings = Object.entries(run).map(([name, value]) => `${name} = ${value}\n`);
  return `precess = 1\n[system]\nid = "${system}"\n${rest}\n[run]\n${settings.join("")}`;
}
