import { svelte } from "@sveltejs/vite-plugin-svelte";
import { readFileSync } from "node:fs";
import { defineConfig, type Plugin } from "vite";
import { catalogue } from "./tools/catalogue.js";

/**
 * `virtual:first-page`: what the catalogue says of the first page's system and its method. The small core that the page
 * loads first has no catalogue; the whole one brings it later.
 */
function firstPage(): Plugin {
  const name = "virtual:first-page";
  return {
    name,
    resolveId: (source) => (source === name ? `\0${name}` : undefined),
    async load(id) {
      if (id !== `\0${name}`) return undefined;
      const { systems, methods } = await catalogue();
      const first = readFileSync(new URL("src/first.toml", import.meta.url), "utf8");
      const wanted = /id = "(\w+)"/.exec(first)?.[1];
      const system = systems.filter((one) => one.id === wanted);
      const method = methods.filter((one) => one.id === system[0]?.defaults.method);
      if (!system.length || !method.length) throw new Error("src/first.toml names no known system");
      return `export default ${JSON.stringify({ systems: system, methods: method, scenarios: [] })};`;
    },
  };
}

/** Every browser that runs WebAssembly reads woff2: KaTeX's older formats need not be shipped. */
const newFonts: Plugin = {
  name: "new-fonts",
  enforce: "pre",
  transform: (code, id) =>
    id.includes("katex.min.css")
      ? code.replace(/,\s*url\([^)]*\.(woff|ttf)\)\s*format\("\w+"\)/g, "")
      : undefined,
};

/** With these a page may share memory with its workers, so that a run can be stopped without being lost. */
const headers = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
};

// The site is served from anywhere, under a policy that allows nothing inline and nothing from elsewhere.
export default defineConfig({
  base: "./",
  plugins: [svelte(), firstPage(), newFonts],
  worker: { format: "es" },
  server: { headers },
  preview: { headers },
  build: {
    chunkSizeWarningLimit: 600,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
});
