import { defineConfig } from "@playwright/test";
import { chromium } from "./tools/chromium.js";

const PORT = Number(process.env["PORT"] ?? 4173);

export default defineConfig({
  testDir: "e2e",
  timeout: 45_000,
  expect: { timeout: 10_000 },
  workers: 1,
  reporter: "line",
  use: {
    baseURL: `http://127.0.0.1:${PORT}/`,
    locale: "en-GB",
    viewport: { width: 1280, height: 900 },
    launchOptions: chromium,
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --host 127.0.0.1 --port ${PORT} --strictPort`,
    url: `http://127.0.0.1:${PORT}/`,
    reuseExistingServer: false,
  },
});
