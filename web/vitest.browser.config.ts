import { defineConfig } from 'vitest/config';

// Drives the built pages in a real browser: one at a time, since they share the processor.
export default defineConfig({
  test: {
    include: ['test/**/*.browser.test.ts', 'viewer/**/*.browser.test.ts', 'report/**/*.browser.test.ts'],
    fileParallelism: false,
    testTimeout: 300_000,
    hookTimeout: 300_000,
    passWithNoTests: true,
  },
});
