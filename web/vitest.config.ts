import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.ts"],
    // The golden runs integrate every system and every method in one test.
    testTimeout: 120_000,
  },
});
