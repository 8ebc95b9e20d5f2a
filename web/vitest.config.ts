import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    environment: "node",
    include: ["tests/**/*.test.ts"],
    // The golden runs integrate ten systems under eight methods in one test.
    testTimeout: 120_000,
  },
});
