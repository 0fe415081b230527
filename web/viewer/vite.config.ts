import { resolve } from 'node:path';
import { defineConfig } from 'vite';

const out = process.env['BERM_WEB_OUT'] ?? resolve(import.meta.dirname, '../dist');

export default defineConfig({
  base: './',
  build: {
    outDir: resolve(out, 'viewer'),
    emptyOutDir: true,
    sourcemap: false,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0, // the page may load nothing but its own files: no data: addresses
    chunkSizeWarningLimit: 1200,
    rollupOptions: {
      output: {
        entryFileNames: 'viewer.js',
        chunkFileNames: '[name].js',
        assetFileNames: '[name][extname]',
      },
    },
  },
});
