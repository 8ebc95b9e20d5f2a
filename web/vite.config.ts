import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";

// The site is served from anywhere, under a policy that allows nothing inline and nothing from elsewhere.
export default defineConfig({
  base: "./",
  plugins: [svelte()],
  worker: { format: "es" },
  build: {
    chunkSizeWarningLimit: 600,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
});
