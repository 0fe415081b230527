import { resolve } from 'node:path';
import { defineConfig, type Plugin } from 'vite';

const out = process.env['BERM_WEB_OUT'] ?? resolve(import.meta.dirname, '../dist');

/** The page names the code that draws, so that the browser fetches it beside the code that asks for it. */
const preloadApp: Plugin = {
  name: 'preload-app',
  transformIndexHtml: {
    order: 'post',
    handler: () => [{ tag: 'link', attrs: { rel: 'modulepreload', href: './app.js' }, injectTo: 'head' }],
  },
};

export default defineConfig({
  base: './',
  plugins: [preloadApp],
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
