import { svelte } from "@sveltejs/vite-plugin-svelte";
import { createHash } from "node:crypto";
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

/** Shaders of materials, maps and effects that no scene has: three asks for them by name, and gets empty ones. */
const unusedShaders = new RegExp(
  String.raw`^\t((?:background|backgroundCube|cube|distance|equirect|linedashed|meshlambert|meshmatcap|meshnormal|` +
    String.raw`meshphong|meshtoon|points|sprite)_(?:vert|frag)|(?:alphahash|alphamap|alphatest|aomap|batching|bumpmap|` +
    String.raw`clearcoat|clipping_planes|displacementmap|dithering|emissivemap|envmap|fog|gradientmap|iridescence|` +
    String.raw`lightmap|lightprobes|lights_(?:lambert|toon|phong)|logdepthbuf|map|morph|normalmap|skin|specularmap|` +
    String.raw`tonemapping|transmission|uv)\w*): [\w$]+`,
  "gm",
);
/** What three hangs on its classes of animations, which no scene has either, and which would stay for that. */
const animation = /^(?:PropertyBinding|\w*(?:Interpolant|KeyframeTrack))\.[^;]*;$/gm;
const lessOfThree: Plugin = {
  name: "less-of-three",
  enforce: "pre",
  transform(code, id) {
    if (id.endsWith("/three.module.js")) return code.replace(unusedShaders, '\t$1: ""');
    if (id.endsWith("/three.core.js")) return code.replace(animation, "");
    return undefined;
  },
};

/** The service worker knows every file of the build. */
const offline: Plugin = {
  name: "offline",
  generateBundle(_, bundle) {
    const files = Object.keys(bundle)
      .filter((file) => file.startsWith("assets/"))
      .sort();
    const version = createHash("sha256").update(files.join()).digest("hex").slice(0, 12);
    const text = readFileSync(new URL("src/offline.js", import.meta.url), "utf8");
    const source = text.replace('["", []]', JSON.stringify([version, files]));
    this.emitFile({ type: "asset", fileName: "offline.js", source });
  },
};

/** With these a page may share memory with its workers, so that a run can be stopped without being lost. */
const headers = {
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Embedder-Policy": "require-corp",
};

// The site is served from anywhere, under a policy that allows nothing inline and nothing from elsewhere.
export default defineConfig({
  base: "./",
  plugins: [svelte(), firstPage(), newFonts, lessOfThree, offline],
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
