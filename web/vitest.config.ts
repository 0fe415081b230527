import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: { include: ['viewer/**/*.test.ts', 'report/**/*.test.ts'], exclude: ['**/*.browser.test.ts'] },
});
